#include <foredraw/overdraw/private/masked_fragments.h>

namespace foredraw {

void MaskedFragments::hand_over(const Fragments& some, const TakeFragments& take_kept,
                                const TakeFragments& take_discarded) {
  for (std::size_t begin = 0; begin < some.count;) {
    const std::uint32_t number = some.triangles[begin];
    while (part_.number(triangle_, false) != number && part_.number(triangle_, true) != number) ++triangle_;
    const std::array<std::uint32_t, 3> vertices = {part_.corners[0][triangle_], part_.corners[1][triangle_],
                                                   part_.corners[2][triangle_]};
    const MaskedTriangle triangle(*part_.mask, camera_, vertices,
                                  {corners_[vertices[0]], corners_[vertices[1]], corners_[vertices[2]]});
    const auto size = static_cast<std::uint32_t>(camera_.size());
    std::size_t end = begin;
    for (; end < some.count && some.triangles[end] == number; ++end) {
      const std::uint32_t pixel = some.pixels[end];
      const auto centre = [](std::uint32_t place) {
        return static_cast<std::int32_t>(place) * subpixels + subpixels / 2;
      };
      Fragments& there = triangle.is_there(centre(pixel % size), centre(pixel / size)) ? kept_ : discarded_;
      there.add(pixel, some.depths[end], number);
    }
    if (kept_.count > 0) kept_.hand_over(take_kept);
    if (discarded_.count > 0) discarded_.hand_over(take_discarded);
    begin = end;
  }
}

}  // namespace foredraw
