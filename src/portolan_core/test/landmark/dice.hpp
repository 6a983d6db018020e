// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/testing/dice.hpp"

namespace portolan::landmark_test {

using testing::Dice;

}  // namespace portolan::landmark_test
