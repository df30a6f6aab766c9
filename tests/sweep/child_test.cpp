// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/child.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "tests/io/folder.hpp"

namespace bagnold::sweep {
namespace {

int exit_code_of(Child& child) {
  for (;;) {
    if (auto const code = child.exit_code()) return *code;
    ::usleep(1000);
  }
}

/// Asked at once, a child has hardly begun: the signal finds it before or behind its exec(). This
/// process has a handler for it, as a sweep has.
TEST(Child, TakesASignalThatComesBeforeItsProgram) {
  io::TestFolder const folder;
  auto const before = std::signal(SIGTERM, [](int) {});
  for (int k = 0; k < 20; ++k) {
    Child child({"sleep", "5"}, folder / "log");
    child.ask_to_stop();
    EXPECT_EQ(exit_code_of(child), 128 + SIGTERM);
  }
  std::signal(SIGTERM, before);
}

TEST(Child, InheritsWhatIsIgnored) {
  io::TestFolder const folder;
  auto const before = std::signal(SIGHUP, SIG_IGN);
  Child child({"sh", "-c", "kill -HUP $$; exit 7"}, folder / "log");
  EXPECT_EQ(exit_code_of(child), 7);
  std::signal(SIGHUP, before);
}

}  // namespace
}  // namespace bagnold::sweep
