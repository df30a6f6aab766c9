// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/law_engines_of.hpp"

template bagnold::LawEngines bagnold::engines_of<bagnold::CDrot>();
