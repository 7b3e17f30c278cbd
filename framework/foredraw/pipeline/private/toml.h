#pragma once
// toml++ so that it says what is wrong by a value. What it would throw it makes where nothing may be thrown, and there
// a program ends that has no memory left; so, too, where it is told a file's name. The shared library is of the other
// kind, so all of it is compiled here.

#undef TOML_SHARED_LIB
#undef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>
