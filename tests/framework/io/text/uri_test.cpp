// Where buffers and images come from, and that nothing outside of the file's folder is opened.
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/text/private/uri.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include "support/gltf_builder.h"
#include "support/test_folder.h"

namespace foredraw::uri_test {
namespace {

namespace fs = std::filesystem;
using testing::GltfBuilder;

RC_GTEST_PROP(GltfUri, percent_encoding_comes_back, (const std::string& path)) {
  RC_ASSERT(gltf::percent_decoded(gltf::percent_encoded(path)) == path);
}

TEST(GltfUri, data_uris_are_decoded_or_refused) {
  const auto text = [](const char* uri) {
    const auto data = gltf::decode_data_uri(uri);
    return data ? std::string(reinterpret_cast<const char*>(data->bytes.data()), data->bytes.size()) : "refused";
  };
  EXPECT_EQ(text("data:text/plain;base64,Zm9yZWRyYXc="), "foredraw");
  EXPECT_EQ(text("data:text/plain;base64,Zm9yZWRyYXc"), "foredraw");
  EXPECT_EQ(text("DATA:,a%20b"), "a b");
  EXPECT_EQ(text("data:;base64,"), "");
  EXPECT_EQ(text("data:application/octet-stream;;base64,AA=="), "refused");
  EXPECT_EQ(text("data:;base64,A"), "refused");
  EXPECT_EQ(text("data:;base64,A*=="), "refused");
  EXPECT_EQ(text("data:;base64"), "refused");
  EXPECT_EQ(text("data:,%4"), "refused");
  EXPECT_EQ(gltf::decode_data_uri("data:image/png;charset=x;base64,AA==")->media_type, "image/png");
}

class GltfFiles : public ::testing::Test {
 protected:
  GltfFiles() {
    fs::create_directories(folder_ / "inside" / "deeper");
    write("secret.bin");
    write("inside/my mesh.bin");
    write("inside/deeper/mesh.bin");
    std::error_code ignored;
    fs::create_symlink("../secret.bin", folder_ / "inside" / "way_out.bin", ignored);
    fs::create_symlink("deeper/mesh.bin", folder_ / "inside" / "way_in.bin", ignored);
    fs::create_directory_symlink("..", folder_ / "inside" / "up", ignored);
  }

  void write(const std::string& name) {
    Diagnostics diagnostics;
    ASSERT_TRUE(write_files(std::vector<OutputFile>{{folder_ / name, testing::ribbon(3).buffer}}, diagnostics));
  }

  /// The code of the refusal of a ribbon whose buffer is at `uri`; empty where it is read.
  std::string code_for(const std::string& uri, std::size_t more = 0) {
    GltfBuilder builder = testing::ribbon(3);
    builder.json["buffers"][0] = {{"uri", uri}, {"byteLength", builder.buffer.size() + more}};
    Diagnostics diagnostics;
    const auto scene =
        read_gltf(testing::bytes_of(builder.json.dump()), "ribbon.gltf", folder_ / "inside", diagnostics);
    EXPECT_EQ(scene.has_value(), !diagnostics.has_errors());
    return diagnostics.empty() ? "" : diagnostics.all().front().code;
  }

  testing::TestFolder own_;
  const fs::path folder_ = own_.path();
};

TEST_F(GltfFiles, buffers_beside_are_found) {
  EXPECT_EQ(code_for("my%20mesh.bin"), "");
  EXPECT_EQ(code_for("my mesh.bin"), "");
  EXPECT_EQ(code_for("deeper/mesh.bin"), "");
  EXPECT_EQ(code_for("./deeper/mesh.bin"), "");
  EXPECT_EQ(code_for("way_in.bin"), "");
}

TEST_F(GltfFiles, buffers_elsewhere_are_refused) {
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("%2e%2e/secret.bin"), std::string("deeper/../../secret.bin"),
        (folder_ / "secret.bin").string(), "file://" + (folder_ / "secret.bin").string(),
        std::string("http://localhost/a.bin"), std::string("C:/a.bin"), std::string("..\\secret.bin"),
        std::string("a%00.bin"), std::string("%zz.bin"), std::string(""), std::string("way_out.bin"),
        std::string("up/secret.bin")}) {
    EXPECT_EQ(code_for(uri), "buffer-uri") << uri;
  }
}

TEST_F(GltfFiles, buffers_elsewhere_are_read_within_the_root) {
  const auto read_within = [&](const std::string& uri, const fs::path& root) {
    GltfBuilder builder = testing::ribbon(3);
    builder.json["buffers"][0] = {{"uri", uri}, {"byteLength", builder.buffer.size()}};
    Diagnostics diagnostics;
    return read_gltf(testing::bytes_of(builder.json.dump()), "ribbon.gltf", folder_ / "inside", diagnostics,
                     {.root = root})
        .has_value();
  };
  EXPECT_TRUE(read_within("../secret.bin", folder_));
  EXPECT_TRUE(read_within("way_out.bin", folder_));
  EXPECT_TRUE(read_within("deeper/mesh.bin", folder_));
  EXPECT_FALSE(read_within("../secret.bin", folder_ / "inside"));
  EXPECT_FALSE(read_within("../secret.bin", folder_ / "inside" / "deeper"));
  EXPECT_FALSE(read_within((folder_ / "secret.bin").string(), folder_));
}

TEST_F(GltfFiles, buffers_must_be_there_and_long_enough) {
  EXPECT_EQ(code_for("gone.bin"), "buffer-missing");
  EXPECT_EQ(code_for("deeper"), "buffer-missing");
  EXPECT_EQ(code_for("my%20mesh.bin", 1), "buffer-length");
}

TEST_F(GltfFiles, images_need_not_be_there_and_keep_pointing_at_the_same_file) {
  GltfBuilder builder = testing::ribbon(1);
  builder.add("images", {{"uri", "deeper/my%20picture.png"}});
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "ribbon.glb", folder_ / "inside", diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  EXPECT_EQ(scene->images[0].uri, "deeper/my%20picture.png");

  const auto uri_at = [&](const fs::path& target) {
    Diagnostics growth;  // by a longer uri
    const auto files = encode_gltf(*scene, target, growth);
    return testing::json_of(files->front().bytes)["images"][0]["uri"].get<std::string>();
  };
  EXPECT_EQ(uri_at(folder_ / "inside" / "out.glb"), "deeper/my%20picture.png");
  EXPECT_EQ(uri_at(folder_ / "out.glb"), "inside/deeper/my%20picture.png");
  EXPECT_EQ(uri_at(folder_ / "other" / "out.gltf"), "../inside/deeper/my%20picture.png");
  EXPECT_TRUE(diagnostics.empty());

  const auto homeless = read_gltf(builder.glb(), "ribbon.glb", {}, diagnostics);
  ASSERT_TRUE(encode_gltf(*homeless, folder_ / "out.glb", diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].severity, Severity::note);
}

TEST_F(GltfFiles, untouched_gltf_takes_its_buffer_along) {
  GltfBuilder builder = testing::ribbon(3);
  builder.json["buffers"][0] = {{"uri", "my%20mesh.bin"}, {"byteLength", builder.buffer.size()}};
  const std::vector<std::byte> input = testing::bytes_of(builder.json.dump(3));
  Diagnostics diagnostics;
  const auto scene = read_gltf(input, "my mesh.gltf", folder_ / "inside", diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  const auto files = encode_gltf(*scene, folder_ / "out.gltf", diagnostics);
  ASSERT_EQ(files->size(), 2u);
  EXPECT_EQ((*files)[0].bytes, input);
  EXPECT_EQ((*files)[1].path, folder_ / "my mesh.bin");
  EXPECT_EQ((*files)[1].bytes, builder.buffer);
  EXPECT_EQ(encode_gltf(*scene, folder_ / "inside" / "out.gltf", diagnostics)->size(), 1u) << "it lies there already";

  const auto shared = read_gltf(input, "ribbon.gltf", folder_ / "inside", diagnostics);
  const auto renamed = encode_gltf(*shared, folder_ / "out.gltf", diagnostics);
  ASSERT_EQ(renamed->size(), 2u);
  EXPECT_EQ((*renamed)[1].path, folder_ / "out.bin") << "another scene may have the buffer, too";
}

}  // namespace
}  // namespace foredraw::uri_test
