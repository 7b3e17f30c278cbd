#pragma once
// Everything that is done with vector registers, done at every width that this processor has.

#include <hwy/targets.h>

#include <cstdint>
#include <functional>

namespace foredraw::testing {

/// The plain code for processors without such registers comes too.
inline void at_every_width(const std::function<void()>& work) {
  hwy::SetSupportedTargetsForTest(0);
  constexpr std::int64_t plain = std::int64_t{1} << 62;
  const auto choose = [](std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  };
  for (std::int64_t left = hwy::SupportedTargets() | plain; left != 0; left &= left - 1) {
    choose(left & -left);
    work();
  }
  choose(0);
}

}  // namespace foredraw::testing
