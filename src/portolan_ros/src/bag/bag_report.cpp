// SPDX-License-Identifier: BSD-3-Clause
#include "bag_report.hpp"

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>

namespace portolan {

namespace {

std::string section(const ReportedMap& map) {
  std::string pictures;
  std::vector<std::string> links;
  for (const std::string& file : map.files) {
    if (boost::ends_with(file, ".png")) {
      pictures += "**" + file + "**\n\n![" + file + "](" + file + ")\n\n";
    } else {
      links.push_back("[" + file + "](" + file + ")");
    }
  }
  std::string text = "\n## " + map.name + "\n\n" + map.used + ".\n\n";
  if (!pictures.empty()) text += pictures + map.legend + "\n\n";
  return text + (links.empty() ? "No map." : "Files: " + boost::join(links, ", ")) + "\n";
}

}  // namespace

std::string bag_report(const std::vector<std::string>& bags, const std::vector<ReportedMap>& maps) {
  std::string text = "# Maps of " + boost::join(bags, ", ") +
                     "\n\nEvery count, and all options: [summary.yaml](summary.yaml).\n";
  for (const ReportedMap& map : maps) text += section(map);
  return text;
}

}  // namespace portolan
