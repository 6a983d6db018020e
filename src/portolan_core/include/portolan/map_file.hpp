// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace portolan {

/// Files that belong together, such as a map's YAML and its picture: bare file name to content.
using FileSet = std::map<std::string, std::string>;

/// True for a name that stays in its folder and in sight there: not empty, no '/', no "..", no dot
/// in front, no control characters.
bool is_bare_name(const std::string& name);

/// Writes the whole set into the folder, or nothing of it: whoever loads afterwards finds all old
/// files or all new ones, even if the process was killed or the power failed in between. Other
/// files in the folder stay as they are. Savers and loaders of one folder wait for each other,
/// across threads and processes (where the file system can lock folders; NFS often cannot, and
/// there one folder must have one saver), though not for ever: half a minute. Throws
/// std::runtime_error, with path and reason, for names that are not bare, and where the system
/// refuses (no such folder, no space, no permission); the old files are then untouched. Only if it
/// refuses when some files of the set are in their places is the set left to `recover`.
void save_files(const std::filesystem::path& folder, const FileSet& files);

/// Reads files of one folder that belong together, all from one save. Throws std::runtime_error
/// with path and reason: a name that `save_files` refuses, no such file, no regular one, or more
/// than `max_bytes` in it [byte].
FileSet load_files(const std::filesystem::path& folder, const std::vector<std::string>& names,
                   std::size_t max_bytes);

/// The same where files name others: `more` is given what has been read, and names what is wanted
/// besides, until that is all there.
FileSet load_files(const std::filesystem::path& folder, const std::vector<std::string>& names,
                   std::size_t max_bytes,
                   const std::function<std::vector<std::string>(const FileSet& found)>& more);

/// Reads one file; throws as `load_files` does, but takes the path as it is.
std::string load_file(const std::filesystem::path& path, std::size_t max_bytes);

/// Finishes a save that was killed after its files were complete, and removes what is left of one
/// that was killed earlier. Saving and loading do that first. Throws std::runtime_error.
void recover(const std::filesystem::path& folder);

namespace map_file_detail {

/// `save_files` that announces each change to the folder before it is made, so that tests can stop
/// it there: what `before` throws is treated like a refusal of the system.
void save_files(const std::filesystem::path& folder, const FileSet& files,
                const std::function<void(const std::string& change)>& before);

}  // namespace map_file_detail

}  // namespace portolan
