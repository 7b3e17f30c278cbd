// URIs that lead out of the file's folder, of buffers and of images.
#include "whole_way.h"

#include "support/gltf_builder.h"
#include "support/program.h"

namespace foredraw::uris_test {
namespace {

namespace fs = std::filesystem;
using testing::GltfBuilder;

class Uris : public testing::InFolder {
 protected:
  Uris() {
    const GltfBuilder ribbon = testing::ribbon(3);
    bytes_ = {reinterpret_cast<const char*>(ribbon.buffer.data()), ribbon.buffer.size()};
    fs::create_directories(folder_ / "inside" / "deeper");
    testing::put(folder_ / "secret.bin", bytes_);
    testing::put(folder_ / "inside" / "data.bin", bytes_);
    fs::create_symlink("../secret.bin", folder_ / "inside" / "link.bin");
    fs::create_symlink(folder_ / "secret.bin", folder_ / "inside" / "absolute_link.bin");
    fs::create_symlink("link.bin", folder_ / "inside" / "link_to_link.bin");
    fs::create_directory_symlink("..", folder_ / "inside" / "up");
    fs::create_symlink("loop.bin", folder_ / "inside" / "loop.bin");
    fs::create_symlink("/dev/zero", folder_ / "inside" / "zero.bin");
    outside_ = {"../secret.bin",
                "..%2fsecret.bin",
                "%2e%2e/secret.bin",
                "%2E%2E%2Fsecret.bin",
                "deeper/../../secret.bin",
                "./../secret.bin",
                "..\\secret.bin",
                "%5c..%5csecret.bin",
                (folder_ / "secret.bin").string(),
                "%2f" + (folder_ / "secret.bin").string().substr(1),
                "file://" + (folder_ / "secret.bin").string(),
                "FILE:///etc/passwd",
                "/etc/passwd",
                "//etc/passwd",
                "http://localhost/a.bin",
                "https://localhost/a.bin",
                "C:/a.bin",
                "c%3a/a.bin",
                "data.bin%00.png",
                "%00",
                "%zz",
                "%",
                "%2",
                "link.bin",
                "absolute_link.bin",
                "link_to_link.bin",
                "up/secret.bin",
                "zero.bin",
                "loop.bin",
                "deeper",
                ".",
                "",
                "data.bin/",
                "/dev/zero"};
  }

  std::string gltf(const std::string& kind, const std::string& uri) const {
    GltfBuilder builder = testing::ribbon(3);
    builder.json["buffers"][0] = {{"uri", kind == "buffers" ? uri : "data.bin"}, {"byteLength", bytes_.size()}};
    if (kind == "images") builder.add("images", {{"uri", uri}});
    return builder.json.dump();
  }

  std::string bytes_;
  std::vector<std::string> outside_;
};

TEST_F(Uris, of_buffers_that_lead_elsewhere_are_refused) {
  const auto codes = [&](const std::string& uri) {
    return testing::go_the_whole_way(testing::bytes_of(gltf("buffers", uri)), folder_ / "inside");
  };
  ASSERT_TRUE(codes("data.bin").empty());
  for (const std::string& uri : outside_) {
    const auto told = codes(uri);
    ASSERT_EQ(told.size(), 1u) << uri;
    EXPECT_TRUE(told[0] == "buffer-uri" || told[0] == "buffer-missing") << uri << ": " << told[0];
  }
}

#ifdef FOREDRAW_PROGRAM
TEST_F(Uris, of_buffers_are_refused_by_the_program_too) {
  for (const std::string& uri : outside_) {
    testing::put(folder_ / "inside" / "in.gltf", gltf("buffers", uri));
    const testing::Ended ended = testing::run_program(folder_, "optimize inside/in.gltf -o out.glb");
    EXPECT_EQ(ended.code, 2) << uri;
    EXPECT_EQ(ended.err.find("inside/in.gltf: error: buffers[0].uri: "), 0u) << uri << '\n' << ended.err;
    EXPECT_FALSE(fs::exists(folder_ / "out.glb")) << uri;
  }
}

/// Images are never opened by us, so their names do no harm here; but nothing may come to lie in the output that was
/// not in the input.
TEST_F(Uris, of_images_are_never_followed) {
  testing::put(folder_ / "secret.bin", "SECRET" + bytes_.substr(6));
  for (const std::string& uri : outside_) {
    testing::put(folder_ / "inside" / "in.gltf", gltf("images", uri));
    const testing::Ended ended =
        testing::run_program(folder_, "optimize inside/in.gltf -o out.glb -p weld,tipsify --with vertex-cache");
    EXPECT_EQ(ended.code, 0) << uri << '\n' << ended.err;
    EXPECT_EQ(testing::content(folder_ / "out.glb").find("SECRET"), std::string::npos) << uri;
  }
}
#endif

}  // namespace
}  // namespace foredraw::uris_test
