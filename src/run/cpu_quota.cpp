// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/cpu_quota.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace bagnold {

namespace {

namespace fs = std::filesystem;

constexpr double no_quota = std::numeric_limits<double>::infinity();

/// A hierarchy of control groups that may have quotas, and the group of this process in it.
struct Hierarchy {
  int version;
  fs::path mount;  ///< where `top` is seen
  std::string top;
  std::string group;
};

bool has(std::string const& list, std::string const& name) {
  return ("," + list + ",").find("," + name + ",") != std::string::npos;
}

/// The group in the lines "ID:CONTROLLERS:GROUP" of /proc/self/cgroup; that of version 2 has no
/// controllers.
std::string group_of(std::string const& lines, int version) {
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    auto const one = line.find(':'), two = line.find(':', one + 1);
    if (one == std::string::npos || two == std::string::npos) continue;
    auto const controllers = line.substr(one + 1, two - one - 1);
    if (version == 2 ? controllers.empty() : has(controllers, "cpu")) return line.substr(two + 1);
  }
  return "/";
}

std::string text_of(fs::path const& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Lines of /proc/self/mountinfo: "ID PARENT DEVICE TOP MOUNT OPTIONS [TAGS] - TYPE SOURCE
/// OPTIONS".
std::vector<Hierarchy> hierarchies(fs::path const& root) {
  auto const groups = text_of(root / "proc/self/cgroup");
  std::istringstream mounts(text_of(root / "proc/self/mountinfo"));
  std::vector<Hierarchy> all;
  for (std::string line; std::getline(mounts, line);) {
    auto const dash = line.find(" - ");
    if (dash == std::string::npos) continue;
    std::istringstream before(line.substr(0, dash)), behind(line.substr(dash + 3));
    std::string skipped, top, mount, type, options;
    before >> skipped >> skipped >> skipped >> top >> mount;
    behind >> type >> skipped >> options;
    if (type != "cgroup2" && !(type == "cgroup" && has(options, "cpu"))) continue;
    int const version = type == "cgroup2" ? 2 : 1;
    all.push_back(
        {version, root / fs::path(mount).relative_path(), top, group_of(groups, version)});
  }
  return all;
}

double quota_v2(fs::path const& folder) {
  std::ifstream in(folder / "cpu.max");  // "max 100000", "150000 100000"
  double quota = 0, period = 0;
  return in >> quota >> period && quota > 0 && period > 0 ? quota / period : no_quota;
}

double quota_v1(fs::path const& folder) {
  std::ifstream first(folder / "cpu.cfs_quota_us"), second(folder / "cpu.cfs_period_us");
  double quota = 0, period = 0;  // "-1": none
  return first >> quota && second >> period && quota > 0 && period > 0 ? quota / period : no_quota;
}

/// Group below the mounted one; in a container both may be named from the host's root.
fs::path below(std::string const& top, std::string const& group) {
  if (top == "/") return fs::path(group).relative_path();
  return group.starts_with(top) ? fs::path(group.substr(top.size())).relative_path() : fs::path();
}

double least_quota(Hierarchy const& hierarchy) {
  double least = no_quota;
  auto const look = [&](fs::path const& folder) {
    least = std::min(least, hierarchy.version == 2 ? quota_v2(folder) : quota_v1(folder));
  };
  fs::path folder = hierarchy.mount;
  look(folder);
  for (auto const& part : below(hierarchy.top, hierarchy.group)) look(folder /= part);
  return least;
}

}  // namespace

double cpu_quota(fs::path const& root) {
  double least = no_quota;
  for (auto const& one : hierarchies(root)) least = std::min(least, least_quota(one));
  return least;
}

}  // namespace bagnold
