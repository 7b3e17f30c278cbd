#include <foredraw/platform/file_facts.h>
#include <foredraw/platform/program_stamp.h>

#include <elf.h>
#include <link.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <vector>

namespace foredraw {

namespace {

/// The build id among an object's notes; empty: there is none.
std::span<const std::byte> build_id(const struct dl_phdr_info& object) {
  for (int i = 0; i < object.dlpi_phnum; ++i) {
    const auto& segment = object.dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    const auto* at = reinterpret_cast<const std::byte*>(object.dlpi_addr + segment.p_vaddr);
    const auto* const end = at + segment.p_memsz;
    const std::size_t step = segment.p_align == 8 ? 8 : 4;
    const auto rounded = [&](std::size_t size) { return (size + step - 1) / step * step; };
    while (at + sizeof(ElfW(Nhdr)) <= end) {
      ElfW(Nhdr) note{};
      std::memcpy(&note, at, sizeof note);
      const std::byte* name = at + sizeof note;
      const std::byte* content = name + rounded(note.n_namesz);
      if (content + note.n_descsz > end) break;
      if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(name, "GNU", 4) == 0) {
        return {content, note.n_descsz};
      }
      at = content + rounded(note.n_descsz);
    }
  }
  return {};
}

int add_stamp(struct dl_phdr_info* object, std::size_t, void* stamps) {
  const std::span<const std::byte> id = build_id(*object);
  const std::string_view name = object->dlpi_name == nullptr ? "" : object->dlpi_name;
  const bool is_program = name.empty();
  if (name.starts_with("linux-vdso") || name.starts_with("linux-gate"))
    return 0;  // the kernel's, by which no byte goes
  if (!id.empty()) {
    static_cast<std::vector<Stamp>*>(stamps)->push_back(content_hash(id));
  } else if (const auto content = hashed_content(is_program ? "/proc/self/exe" : name, ~std::uint64_t{0})) {
    static_cast<std::vector<Stamp>*>(stamps)->push_back(content->stamp);
  }
  return 0;
}

}  // namespace

Stamp program_stamp() {
  std::vector<Stamp> stamps;
  ::dl_iterate_phdr(add_stamp, &stamps);
  std::ranges::sort(stamps);  // whatever the sequence of loading is
  return combine(stamps);
}

}  // namespace foredraw
