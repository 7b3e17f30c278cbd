#include "evaluators/vertex_precision/vertex_precision.h"

#include <gtest/gtest.h>
