#pragma once
// FBX files as text, piece by piece.

#include <string>
#include <string_view>
#include <vector>

namespace foredraw::testing {

struct FbxAxes {
  int up = 1, up_sign = 1, front = 2, front_sign = 1, right = 0, right_sign = 1;
};

/// An ASCII FBX file of version 7.4. Objects have numbers that the test gives.
class FbxBuilder {
 public:
  explicit FbxBuilder(FbxAxes axes = {}, double centimetres = 1) : axes_(axes), unit_(centimetres) {}

  /// `faces`: corners of polygons, the last of each as -1 - corner. `uv`: two numbers for each corner, or none.
  void mesh(int number, const std::string& name, const std::vector<double>& points, const std::vector<int>& faces,
            const std::vector<double>& uv = {}) {
    objects_ += "Geometry: " + id(number) + ", \"Geometry::" + name + "\", \"Mesh\" {\n" + array("Vertices", points) +
                array("PolygonVertexIndex", faces) + "GeometryVersion: 124\n";
    if (!uv.empty()) {
      objects_ +=
          "LayerElementUV: 0 {\nVersion: 101\nName: \"map\"\nMappingInformationType: \"ByPolygonVertex\"\n"
          "ReferenceInformationType: \"Direct\"\n" +
          array("UV", uv) + "}\n";
    }
    objects_ +=
        "LayerElementMaterial: 0 {\nVersion: 101\nName: \"\"\nMappingInformationType: \"AllSame\"\n"
        "ReferenceInformationType: \"IndexToDirect\"\n" +
        array("Materials", std::vector<int>{0}) + "}\nLayer: 0 {\nVersion: 100\n" +
        (uv.empty() ? "" : "LayerElement: {\nType: \"LayerElementUV\"\nTypedIndex: 0\n}\n") +
        "LayerElement: {\nType: \"LayerElementMaterial\"\nTypedIndex: 0\n}\n}\n}\n";
  }

  /// `kind`: "Mesh", "LimbNode", "Null". `properties`: by vector().
  void node(int number, const std::string& name, const std::string& kind, const std::string& properties = {}) {
    objects_ += "Model: " + id(number) + ", \"Model::" + name + "\", \"" + kind +
                "\" {\nVersion: 232\nProperties70: {\n" + properties + "}\nShading: T\nCulling: \"CullingOff\"\n}\n";
  }
  static std::string vector(const std::string& name, double x, double y, double z) {
    const std::string type = name.starts_with("Lcl") ? name : "Vector3D";
    return "P: \"" + name + "\", \"" + type + "\", \"\", \"A\"," + text(x) + ',' + text(y) + ',' + text(z) + '\n';
  }

  void skin(int number, int mesh) {
    objects_ += "Deformer: " + id(number) + ", \"Deformer::\", \"Skin\" {\nVersion: 101\nLink_DeformAcuracy: 50\n}\n";
    connect(number, mesh);
  }
  /// `bone_up`: how far along the file's z axis the bone stands.
  void cluster(int number, int skin, int bone, const std::vector<int>& points, const std::vector<double>& weights,
               double bone_up) {
    objects_ += "Deformer: " + id(number) + ", \"SubDeformer::\", \"Cluster\" {\nVersion: 100\nUserData: \"\", \"\"\n" +
                array("Indexes", points) + array("Weights", weights) +
                array("Transform", std::vector<double>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -bone_up, 1}) +
                array("TransformLink", std::vector<double>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, bone_up, 1}) +
                "}\n";
    connect(number, skin);
    connect(bone, number);
  }

  /// A target of a mesh: its channel has the number after `number`, its shape the one after that.
  void target(int number, int mesh, const std::string& name, const std::vector<int>& points,
              const std::vector<double>& moves) {
    objects_ += "Deformer: " + id(number) +
                ", \"Deformer::\", \"BlendShape\" {\nVersion: 100\n}\nDeformer: " + id(number + 1) +
                ", \"SubDeformer::" + name + "\", \"BlendShapeChannel\" {\nVersion: 100\nDeformPercent: 0\n" +
                array("FullWeights", std::vector<double>{100}) + "}\nGeometry: " + id(number + 2) +
                ", \"Geometry::" + name + "\", \"Shape\" {\nVersion: 100\n" + array("Indexes", points) +
                array("Vertices", moves) + array("Normals", std::vector<double>(moves.size(), 0.0)) + "}\n";
    connect(number, mesh);
    connect(number + 1, number);
    connect(number + 2, number + 1);
  }

  void material(int number, const std::string& name, int node) {
    objects_ += "Material: " + id(number) + ", \"Material::" + name +
                "\", \"\" {\nVersion: 102\nShadingModel: \"phong\"\nMultiLayer: 0\nProperties70: {\n" +
                "P: \"DiffuseColor\", \"Color\", \"\", \"A\",0.5,0.25,1\n}\n}\n";
    connect(number, node);
  }
  /// `properties`: by vector().
  void texture(int number, int material, const std::string& file, const std::string& properties = {}) {
    objects_ += "Texture: " + id(number) +
                ", \"Texture::picture\", \"\" {\nType: \"TextureVideoClip\"\nVersion: 202\n"
                "TextureName: \"Texture::picture\"\nProperties70: {\n" +
                properties + "}\nFileName: \"" + file + "\"\nRelativeFilename: \"" + file + "\"\n}\n";
    connect(number, material, "DiffuseColor");
  }
  /// The content of a texture's file, in base64.
  void video(int number, int texture, const std::string& file, const std::string& content) {
    objects_ += "Video: " + id(number) + ", \"Video::picture\", \"Clip\" {\nType: \"Clip\"\nFileName: \"" + file +
                "\"\nRelativeFilename: \"" + file + "\"\nContent: , \"" + content + "\"\n}\n";
    connect(number, texture);
  }

  /// The layer of a clip has the number after `number`.
  void clip(int number, const std::string& name, double begins, double ends) {
    objects_ += "AnimationStack: " + id(number) + ", \"AnimStack::" + name + "\", \"\" {\nProperties70: {\n" +
                "P: \"LocalStart\", \"KTime\", \"Time\", \"\"," + ticks(begins) +
                "\nP: \"LocalStop\", \"KTime\", \"Time\", \"\"," + ticks(ends) +
                "\n}\n}\nAnimationLayer: " + id(number + 1) + ", \"AnimLayer::\", \"\" {\n}\n";
    connect(number + 1, number);
  }
  struct Key {
    double seconds, value;
  };
  /// Keys of one number: `property` "Lcl Rotation" and `part` "d|X". The curve has the number after `number`.
  void curve(int number, int layer, int of, const std::string& property, const std::string& part,
             const std::vector<Key>& keys) {
    std::vector<std::string> times;
    std::vector<double> values;
    for (const Key& key : keys) {
      times.push_back(ticks(key.seconds));
      values.push_back(key.value);
    }
    const char* kind = property == "Lcl Rotation" ? "R" : property == "Lcl Translation" ? "T" : property.c_str();
    objects_ += "AnimationCurveNode: " + id(number) + ", \"AnimCurveNode::" + kind +
                "\", \"\" {\nProperties70: {\nP: \"" + part + "\", \"Number\", \"\", \"A\"," + text(values[0]) +
                "\n}\n}\nAnimationCurve: " + id(number + 1) + ", \"AnimCurve::\", \"\" {\nDefault: 0\nKeyVer: 4008\n" +
                array("KeyTime", times) + array("KeyValueFloat", values) + array("KeyAttrFlags", std::vector<int>{4}) +
                array("KeyAttrDataFloat", std::vector<double>{0, 0, 0, 0}) +
                array("KeyAttrRefCount", std::vector<int>{static_cast<int>(keys.size())}) + "}\n";
    connect(number, layer);
    connect(number, of, property);
    connect(number + 1, number, part);
  }

  /// 0 is the scene.
  void connect(int from, int to, const std::string& property = {}) {
    connections_ += "C: \"" + std::string(property.empty() ? "OO" : "OP") + "\"," + id(from) + ',' + id(to) +
                    (property.empty() ? "" : ", \"" + property + '"') + '\n';
  }

  std::string text() const {
    const auto number = [](const char* name, const std::string& value) {
      return std::string("P: \"") + name + "\", \"int\", \"Integer\", \"\"," + value + '\n';
    };
    return "; FBX 7.4.0 project file\nFBXHeaderExtension: {\nFBXHeaderVersion: 1003\nFBXVersion: 7400\n"
           "Creator: \"a test\"\n}\nGlobalSettings: {\nVersion: 1000\nProperties70: {\n" +
           number("UpAxis", id(axes_.up)) + number("UpAxisSign", id(axes_.up_sign)) +
           number("FrontAxis", id(axes_.front)) + number("FrontAxisSign", id(axes_.front_sign)) +
           number("CoordAxis", id(axes_.right)) + number("CoordAxisSign", id(axes_.right_sign)) +
           "P: \"UnitScaleFactor\", \"double\", \"Number\", \"\"," + text(unit_) +
           "\nP: \"TimeMode\", \"enum\", \"\", \"\",11\n}\n}\nObjects: {\n" + objects_ + "}\nConnections: {\n" +
           connections_ + "}\n";
  }

 private:
  static std::string id(int number) { return std::to_string(number); }
  static std::string text(double value) { return std::to_string(value); }
  static std::string text(int value) { return std::to_string(value); }
  static std::string text(const std::string& value) { return value; }
  static std::string ticks(double seconds) { return std::to_string(static_cast<long long>(seconds * 46186158000.0)); }

  template <class Value>
  static std::string array(std::string_view name, const std::vector<Value>& values) {
    std::string all = std::string(name) + ": *" + std::to_string(values.size()) + " {\na: ";
    for (std::size_t i = 0; i < values.size(); ++i) all += (i == 0 ? "" : ",") + text(values[i]);
    return all + "\n}\n";
  }

  FbxAxes axes_;
  double unit_;
  std::string objects_, connections_;
};

struct Leaf {
  FbxAxes axes = {};
  double centimetres = 1;
  std::string properties = {};  ///< of its node
  std::vector<double> uv = {};
};
/// One triangle, (0, 0, 0), (100, 0, 0), (0, 0, 200): mesh 100 on node 200.
inline FbxBuilder leaf(const Leaf& made = {}) {
  FbxBuilder file(made.axes, made.centimetres);
  file.mesh(100, "leaf", {0, 0, 0, 100, 0, 0, 0, 0, 200}, {0, 1, -3}, made.uv);
  file.node(200, "leaf", "Mesh", made.properties);
  file.connect(100, 200);
  file.connect(200, 0);
  return file;
}

/// A bar of 2 m by 20 cm that stands along Z, in centimetres, as 3ds Max and Blender have the axes: bones "root" and
/// "tip" at its foot and its middle. In one second "Bend" turns the tip by 90 degrees, so that it points to glTF's +Z.
inline FbxBuilder bending_bar(const std::string& name = "bar", const std::string& properties = {}) {
  FbxBuilder file({.up = 2, .front = 1, .front_sign = -1});
  std::vector<double> points;
  for (const double z : {0.0, 100.0, 200.0}) {
    for (const auto& [x, y] : {std::pair{-10.0, -10.0}, {10.0, -10.0}, {10.0, 10.0}, {-10.0, 10.0}}) {
      points.insert(points.end(), {x, y, z});
    }
  }
  std::vector<int> faces;
  for (const int ring : {0, 4}) {
    for (int k = 0; k < 4; ++k) {
      const int next = (k + 1) % 4;
      faces.insert(faces.end(), {ring + k, ring + next, ring + next + 4, -1 - (ring + k + 4)});
    }
  }
  file.mesh(100, name, points, faces);
  file.node(200, name, "Mesh", properties);
  file.node(300, "root", "LimbNode");
  file.node(301, "tip", "LimbNode", FbxBuilder::vector("Lcl Translation", 0, 0, 100));
  file.connect(100, 200);
  file.connect(200, 0);
  file.connect(300, 0);
  file.connect(301, 300);
  file.skin(400, 100);
  file.cluster(401, 400, 300, {0, 1, 2, 3, 4, 5, 6, 7}, {1, 1, 1, 1, 1, 1, 1, 1}, 0);
  file.cluster(402, 400, 301, {8, 9, 10, 11}, {1, 1, 1, 1}, 100);
  file.material(250, "steel", 200);
  file.clip(500, "Bend", 1, 2);
  std::vector<FbxBuilder::Key> keys;
  for (int frame = 0; frame <= 24; ++frame) keys.push_back({1 + frame / 24.0, 90.0 * frame / 24});
  file.curve(510, 501, 301, "Lcl Rotation", "d|X", keys);
  return file;
}

}  // namespace foredraw::testing
