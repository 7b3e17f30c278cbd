#pragma once
// Options that techniques for sprites share, so that they are spelled alike.

#include <foredraw/image/alpha_image.h>
#include <foredraw/technique/options.h>

namespace foredraw {

/// The row `channel`.
template <class Options, class Owner>
void add_alpha_channel(OptionTable<Options>& table, AlphaChannel Owner::*channel) {
  table.choice(channel, "channel",
               "What counts as alpha: the image's own alpha, or, for sprites that are blended additively, the "
               "luminance of the colour or the greatest of its channels",
               {{"alpha", AlphaChannel::alpha}, {"luminance", AlphaChannel::luminance}, {"any", AlphaChannel::any}});
}

/// Code and text of a note on images whose alpha is made up: their figures look as if nothing could be gained.
struct NoAlpha {
  static constexpr const char* code = "no-alpha";
  static constexpr const char* text =
      "its image has no alpha, so every texel counts as visible; if the sprite is blended additively, set channel = "
      "\"luminance\"";
};

}  // namespace foredraw
