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

}  // namespace foredraw
