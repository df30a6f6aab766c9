// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "src/analysis/report.hpp"

namespace bagnold::analysis {

/// panel; quantities on the axes; "log" or "linear" for each; curve; "data", "fit" or "mark"; x, y
/// and their errors.
extern std::vector<std::string> const drawn_columns;

/// One panel of the picture.
class Panel {
 public:
  Panel(Report& report, std::string x_name, std::string y_name, bool log_x, bool log_y);

  void data(std::string const& curve, Points const& points,
            std::vector<double> const& x_error = {});
  void point(std::string const& what, std::string const& curve, double x, double x_error, double y,
             double y_error);
  void line(std::string const& curve, Line const& line);

 private:
  Report& report_;
  std::vector<std::string> head_;
};

/// "Q = 10, gammadot = 1e-05"; labels of `skip` are left out.
std::string caption(std::vector<Label> const& labels, std::string const& skip = "");

/// Q, phi, gammadot, N for the keys that have a letter; else the name.
std::string symbol(std::string const& name);

/// A parameter of all outcomes to draw, and the name of its points; "" takes the labels alone.
struct DrawnParameter {
  std::size_t index;
  std::string name = {};
};

/// Draws parameters, on the axis `axis`, against the only label of all outcomes that is a number
/// and differs, in ascending order; phi is always the abscissa. Nothing if there is no such label.
void draw_against_label(Report& report, std::vector<Outcome> const& outcomes,
                        std::vector<DrawnParameter> const& parameters, std::string const& axis,
                        bool log_value);

}  // namespace bagnold::analysis
