#include <foredraw/platform/machine.h>

#include <sys/utsname.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>

namespace foredraw {

namespace {

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "";
}

std::string memory_size() {
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long page = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page <= 0) return "";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f GiB", static_cast<double>(pages) * static_cast<double>(page) / 0x1p30);
  return text.data();
}

}  // namespace

std::string machine_text() {
  std::string text = processor_name();
  const auto add = [&](const std::string& part) {
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
  };
  const long processors = ::sysconf(_SC_NPROCESSORS_ONLN);
  if (processors > 0) add(std::to_string(processors) + (processors == 1 ? " processor" : " processors"));
  add(memory_size());
  struct utsname system {};
  if (::uname(&system) == 0) add(std::string(system.sysname) + ' ' + system.release + ' ' + system.machine);
  return text;
}

}  // namespace foredraw
