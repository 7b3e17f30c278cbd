#include "plugins/processors/quantize/quantize.h"

#include <gtest/gtest.h>

namespace foredraw {
namespace {

TEST(Quantize, ALatticeIsAsCoarseAsTheErrorAllows) {
  EXPECT_EQ(lattice_exponent(1, 1), 1);
  EXPECT_EQ(lattice_exponent(.5, 1), 0);
  EXPECT_EQ(lattice_exponent(.49, 1), -1);
  EXPECT_EQ(lattice_exponent(1, 3), 0);
}

}  // namespace
}  // namespace foredraw
