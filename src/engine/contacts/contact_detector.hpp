// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernels/cpu/contacts/contact_event.hpp"
#include "kernels/cpu/contacts/contact_sample.hpp"
#include "kernels/cpu/steps/block_system.hpp"
#include "src/engine/blocks/block_loop.hpp"
#include "src/engine/contacts/contact_record.hpp"

namespace bagnold {

/// Detects beginnings and ends of contacts of disks in blocks.
///
/// For each place of the inner lists it keeps whether the pair was in contact a step before. When
/// these lists are pruned anew, it reads that from the record's table of open contacts, which does
/// not depend on lists.
class ContactDetector {
 public:
  /// Detects contacts that begin or end in the configuration at `step`, and adds its sums if it is
  /// sampled.
  void detect(BlockLoop& loop, BlockSystem const& all, ShearedBox const& box, std::int64_t step,
              Sampling const& sampling, OpenWindows& windows);

  /// Ends contacts that no longer exist in the configuration at `step`, whatever the lists.
  void close_parted(BlockSystem const& all, ShearedBox const& box, std::int64_t step,
                    Sampling const& sampling, OpenWindows& windows);

  /// Index at the start of the disk in a slot.
  std::uint32_t disk(std::uint32_t slot) const { return disk_of_[slot]; }

  /// Collects events, and passes them on.
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
