#pragma once
// The processor time of another process: it shows that the process has begun, however busy the machine is.

#include "support/program.h"

#include <sys/types.h>
#include <unistd.h>

#include <chrono>
#include <sstream>
#include <string>
#include <thread>

namespace foredraw::testing {

/// Seconds that the process has used, all its threads together; 0 if there is no such process.
inline double seconds_worked(const std::string& process) {
  const std::string stat = content("/proc/" + process + "/stat");
  std::istringstream fields(stat.substr(stat.rfind(')') + 1));  // a name may hold spaces
  std::string field;
  for (int i = 3; i < 14; ++i) fields >> field;
  long user = 0, system = 0;
  fields >> user >> system;
  return static_cast<double>(user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// Waits until `holds` returns true. Returns false after five minutes.
template <class Holds>
bool comes_true(Holds holds) {
  for (int tries = 0; tries < 15'000; ++tries) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

}  // namespace foredraw::testing
