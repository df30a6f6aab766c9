// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"
#include "src/engine/simulation.hpp"
#include "src/statistics/windows.hpp"

namespace bagnold {

/// Decides on the pieces of one system, each from the sums of the piece before, and adds up their
/// sums to windows.
class Controller {
 public:
  /// Strain rate, [1/tau_e], and box of a piece, its length over that of the piece before.
  struct Piece {
    double rate;
    double scale = 1;
  };

  /// box_length: L_x where it takes over, [d_s].
  Controller(Scene const& scene, Plan const& plan, double box_length);
  virtual ~Controller() = default;

  /// Takes the sums of the piece that has ended, and begins the next one. Adds a window to
  /// `windows` where its last piece has ended.
  void end_piece(Simulation& simulation, WindowSums const& piece, statistics::Windows& windows);

  /// All that a restart needs, for a checkpoint.
  std::vector<double> memory() const;
  void load(std::vector<double> const& memory);

 protected:
  using Averages = std::span<double const>;

  /// A piece that has ended.
  struct Ended {
    std::int64_t step;  ///< after its last one
    double rate;        ///< [1/tau_e]
    Averages averages;  ///< of SumColumns, those per area over L_x L_y of the scene
  };

  virtual Piece next(Ended const& piece) = 0;

  /// Numbers of a controller beside the rate and the box.
  virtual std::vector<double*> numbers() { return {}; }

  Scene const& scene() const { return scene_; }
  Plan const& plan() const { return plan_; }
  double piece_time() const { return plan_.time_step * static_cast<double>(plan_.control_steps); }

  /// A quantity as a function of averages.
  std::function<double(Averages)> quantity(std::string_view name) const;

 private:
  Scene scene_;
  Plan plan_;
  double rate_;        ///< of the present piece, [1/tau_e]
  double length_;      ///< of the present box over that of the scene
  WindowSums window_;  ///< of its pieces so far
};

/// Name of what a controller remembers, among the arrays of a checkpoint.
inline constexpr char controller_name[] = "controller";

/// Controller of a scene; null where no controller decides.
std::unique_ptr<Controller> make_controller(Scene const& scene, Plan const& plan,
                                            double box_length);

}  // namespace bagnold
