// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/block_loop.hpp"

#include "kernels/cpu/blocks/build_blocks.hpp"
#include "src/engine/backends.hpp"
#include "src/engine/device_copy.hpp"

namespace bagnold {

namespace {

template <class Space>
class LoopOn final : public BlockLoop {
 public:
  int threads() const override { return tokens_.size(); }

  Blocks build(std::vector<Vec2<Real>> const& position, std::vector<Species> const& species,
               SpeciesTable const& table, ShearedBox const& box, Real skin,
               std::uint32_t size) override {
    return build_blocks(space_, to_device<Space>("blocks::position", position),
                        to_device<Space>("blocks::species", species), table, box, skin, size);
  }

 private:
  void run(std::uint32_t count, std::size_t scratch_bytes, void const* body, Call call) override {
    auto const stride = (scratch_bytes + 63) / 64 * 64;
    auto const bytes = stride * static_cast<std::size_t>(tokens_.size());
    if (scratch_.extent(0) < bytes) {
      scratch_ = {};
      scratch_ = Kokkos::View<std::byte*, Kokkos::HostSpace>(
          Kokkos::view_alloc(Kokkos::WithoutInitializing, std::string("simulation::scratch")),
          bytes);
    }
    if (count == 1) return call(body, 0, scratch_.data());  // not worth a parallel region
    side_by_side::parallel_for("simulation::BlockLoop", Policy(space_, 0, count),
                               [&](std::int64_t b) {
                                 int const token = stride == 0 ? 0 : tokens_.acquire();
                                 call(body, static_cast<std::uint32_t>(b),
                                      scratch_.data() + stride * static_cast<std::size_t>(token));
                                 if (stride != 0) tokens_.release(token);
                               });
  }

  using Policy = Kokkos::RangePolicy<Space, Kokkos::IndexType<std::int64_t>>;
  Space space_{};
  Kokkos::Experimental::UniqueToken<Space> tokens_;
  Kokkos::View<std::byte*, Kokkos::HostSpace> scratch_;
};

}  // namespace

std::unique_ptr<BlockLoop> make_block_loop(std::string const& backend) {
  using Made = std::unique_ptr<BlockLoop>;
  return on_backend<Made>(backend, []<class Space>(std::type_identity<Space>) -> Made {
    if constexpr (is_device<Space>)
      return nullptr;
    else
      return std::make_unique<LoopOn<Space>>();
  });
}

}  // namespace bagnold
