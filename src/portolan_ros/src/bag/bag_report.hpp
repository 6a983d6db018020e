// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace portolan {

/// A map as the report of a run shows it.
struct ReportedMap {
  std::string name;
  std::string legend;              ///< of its pictures
  std::string used;                ///< what became of the messages, in words
  std::vector<std::string> files;  ///< beside the report; pictures are shown, others linked
};

/// A page in Markdown: the maps that were drawn of these bags.
std::string bag_report(const std::vector<std::string>& bags, const std::vector<ReportedMap>& maps);

}  // namespace portolan
