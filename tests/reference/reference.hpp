// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The whole oracle: parameters, contacts, forces, the step, sums, and two disks in closed form.
#include "tests/reference/binary_collision.hpp"
#include "tests/reference/measure.hpp"
#include "tests/reference/system.hpp"
