#include "plugins/processors/vertex_pack/vertex_pack.h"

#include <gtest/gtest.h>
