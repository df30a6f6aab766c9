// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernels/cpu/contacts/contact_event.hpp"
#include "kernels/cpu/contacts/contact_sample.hpp"
#include "kernels/cpu/steps/block_system.hpp"
#include "src/engine/blocks/block_loop.hpp"
#include "src/engine/contacts/contact_record.hpp"

namespace bagnold {

/// Sees the contacts of disks in blocks begin and end.
///
/// Which pairs were in contact a step before is kept for each place of the inner lists; where these
/// were taken anew, the record's table of open contacts says it, which knows nothing of lists.
class ContactDetector {
 public:
  /// What has begun or ended in the configuration at `step`, and its sums if it is sampled.
  void detect(BlockLoop& loop, BlockSystem const& all, ShearedBox const& box, std::int64_t step,
              Sampling const& sampling, OpenWindows& windows);

  /// Ends the contacts that are none any more in the configuration at `step`, wherever lists stand.
  void close_parted(BlockSystem const& all, ShearedBox const& box, std::int64_t step,
                    Sampling const& sampling, OpenWindows& windows);

  /// The index at the start of the disk in a slot.
  std::uint32_t disk(std::uint32_t slot) const { return disk_of_[slot]; }

  /// Takes events to be told, and tells them.
  void take(std::vector<ContactEvent>& events);
  void take(std::vector<ContactSample>& samples);
  void tell(Sampling const& sampling, OpenWindows& windows);

 private:
  void know_disks(BlockSystem const& all);
  void list(BlockSystem const& all, ContactTable const& table);

  std::int64_t arrangement_ = 0;                  ///< of the blocks that disk_of_ is for
  std::int64_t listing_ = 0;                      ///< of the inner lists that touched_ is for
  std::vector<std::uint32_t> disk_of_;            ///< by slot
  std::vector<std::uint8_t> touched_;             ///< a byte for each pack of the inner lists
  std::vector<std::vector<ContactEvent>> found_;  ///< by block
  std::vector<std::vector<ContactPick>> picks_;   ///< by block
  std::vector<ContactMotion> motion_;             ///< by block
  std::vector<ContactEvent> events_;
  std::vector<ContactSample> samples_;
};

}  // namespace bagnold
