#include <foredraw/platform/shared_library.h>

#include <dlfcn.h>

#include <stdexcept>
#include <system_error>

namespace foredraw {

namespace fs = std::filesystem;

LoadedLibrary::LoadedLibrary(const fs::path& path)
    : handle_(::dlopen(fs::absolute(path).string().c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (handle_ != nullptr) return;
  const char* why = ::dlerror();
  throw std::runtime_error(why == nullptr ? "it can not be loaded" : why);
}

void* LoadedLibrary::symbol(const std::string& name) const { return ::dlsym(handle_, name.c_str()); }

fs::path own_folder() {
  Dl_info info{};
  std::error_code error;
  if (::dladdr(reinterpret_cast<const void*>(&own_folder), &info) == 0 || info.dli_fname == nullptr) return {};
  return fs::absolute(info.dli_fname, error).parent_path();
}

fs::path program_folder() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path();
}

}  // namespace foredraw
