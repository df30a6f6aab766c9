// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/cli/commands.hpp"

namespace bagnold {

/// Arguments and options of `bagnold analyse`, read into `options`, which must outlive the parsing.
void add_analyse_options(Words command, AnalyseOptions& options);

}  // namespace bagnold
