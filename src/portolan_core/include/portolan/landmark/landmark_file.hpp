// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "portolan/landmark/landmark_mapper.hpp"

namespace portolan {

/// The map as YAML: `version`, and `landmarks` with `id, mean: [x, y, z], covariance: [9,
/// row-major], sightings, existence, evidence, kind` [m]; `evidence` is the log-odds of existence.
/// Where no sensor told the height there are `flat: true` and, in `height`, what is assumed of it.
/// `independent` is the covariance without what repeats in all sightings, where that differs.
/// A ray has `ray` with `coordinates: [theta, phi, rho], covariance: [9], origin: [x, y, z],
/// axes: [9, row-major]`.
std::string to_yaml(const LandmarkMapper& mapper);

/// The mapper that goes on from what `to_yaml` wrote; written again it gives the same text. What
/// may yet become a landmark is not in the file, nor where the sensor sees. Throws
/// std::runtime_error that says what is wrong: version, sizes, numbers that are not finite,
/// covariances that are none, an id twice. Without `sightings` or `existence`, 1 and a half
/// stand in.
LandmarkMapper landmarks_from_yaml(const std::string& text, const LandmarkOptions& options);

}  // namespace portolan
