// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "bench/accuracy/commands.hpp"
#include "kernels/device/initialize_kokkos.hpp"
#include "src/config/errors.hpp"

int main(int argc, char** argv) {
  using namespace bagnold;
  CLI::App app("Schemes and time steps: what they cost, and how wrong they are. Prints CSV.");
  app.require_subcommand(1);
  accuracy::add_collision(app);
  accuracy::add_stability(app);
  accuracy::add_steady(app);
  accuracy::add_stretch(app);
  initialize_kokkos(1);
  int status = 0;
  try {
    app.parse(argc, argv);
  } catch (CLI::ParseError const& error) {
    status = app.exit(error) == 0 ? 0 : 2;
  } catch (InputError const& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    status = 2;
  } catch (std::exception const& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    status = 4;
  }
  Kokkos::finalize();
  return status;
}
