// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold {

/// /dev/null on each of stdin, stdout and stderr that is closed: else the first files that are
/// opened would take their numbers, and messages would be written into results.
void open_standard_streams();

}  // namespace bagnold
