#pragma once
#include <string>

namespace foredraw {

/// What times were measured on: "AMD EPYC 7B13, 2 processors, 23.5 GiB, Linux 6.1.0 x86_64". What this system does not
/// tell is left out.
std::string machine_text();

}  // namespace foredraw
