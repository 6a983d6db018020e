// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/graph/loop/place_search_options.hpp"
#include "portolan/graph/match/correlative.hpp"
#include "portolan/options.hpp"

namespace portolan {

/// Where loops are looked for, and what is asked of one.
struct LoopOptions {
  bool enabled = true;
  double every = 2.0;
  double min_way = 15.0;
  double distance = 4.0;
  int enough = 20;
  double min_doubt = 0.25;
  double map_way = 5.0;
  int candidates = 2;
  double max_reach = 15.0;
  double max_turn = 0.6;
  double min_shared = 0.35;
  double min_agreed = 0.8;
  double margin = 0.2;
  double max_rivalry = 0.92;
  double max_open = 0.3;
  int min_confirmations = 2;
  double confirmation_way = 4.0;
  double confirmation_reach = 30.0;
  CorrelativeOptions search;
  PlaceSearchOptions places;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("enabled", self.enabled, "look for places where the robot has been before");
    visit("every", self.every, "look again after so much way [m]", at_least(0.0));
    visit("min_way", self.min_way, "way between two visits, at least [m]", at_least(0.0));
    visit("distance", self.distance,
          "visits to a place lie so close, besides what is uncertain [m]", above(0.0));
    visit("enough", self.enough,
          "where so many loops have been closed within that distance, visits are compared only if "
          "the graph leaves them in doubt of each other",
          at_least(0));
    visit("min_doubt", self.min_doubt,
          "such a deviation of the one as seen from the other, of what stands map_way away, is "
          "doubt; 0: compare always [m]",
          at_least(0.0));
    visit("map_way", self.map_way,
          "way before and after a keyframe whose scans are matched as one map [m]", above(0.0));
    visit("candidates", self.candidates, "earlier visits that are tried at a time", at_least(1.0));
    visit("max_reach", self.max_reach, "half side of the largest area that is searched [m]",
          above(0.0));
    visit("max_turn", self.max_turn, "largest turn that is searched either way [rad]", above(0.0));
    visit("min_shared", self.min_shared, "share of the surfaces that both visits could see",
          within(0.0, 1.0));
    visit("min_agreed", self.min_agreed, "share of those that both saw in the same place",
          within(0.0, 1.0));
    visit("margin", self.margin, "surfaces this close are in the same place [m]", above(0.0));
    visit("max_rivalry", self.max_rivalry,
          "score of another place, relative to the best one, that makes both ambiguous",
          within(0.0, 1.0));
    visit("max_open", self.max_open,
          "deviation that the graph may leave along a direction in which the surfaces do not hold "
          "the pose [m]",
          at_least(0.0));
    visit("min_confirmations", self.min_confirmations,
          "other loops that must say the same before one counts", at_least(0.0));
    visit("confirmation_way", self.confirmation_way,
          "way over which loops that confirm each other must spread [m]", at_least(0.0));
    visit("confirmation_reach", self.confirmation_reach,
          "loops whose ends lie within this way of each other are compared [m]", above(0.0));
    visit("search", self.search, "the wide search");
    visit("places", self.places, "the search through the whole graph");
  }
};

}  // namespace portolan
