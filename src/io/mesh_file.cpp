#include "io/mesh_file.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "io/mesh_text.hpp"
#include "io/obj_file.hpp"
#include "io/ply_file.hpp"

namespace graze::io {

namespace {

void append_mesh(const aiMesh& mesh, const aiMatrix4x4& map, TriangleSoup& soup) {
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D v = map * mesh.mVertices[i];
    soup.points.push_back(
        validate::point(Vec3d{static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)},
                        "points[" + std::to_string(soup.points.size()) + "]"));
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) continue;
    for (unsigned k = 0; k < 3; ++k)
      if (face.mIndices[k] >= mesh.mNumVertices)
        throw InvalidValue("faces[" + std::to_string(i) + "]", "an index below " + std::to_string(mesh.mNumVertices),
                           std::to_string(face.mIndices[k]));
    soup.triangles.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
  }
}

/// assimp's words on one line, without the name that it gives to bytes in memory.
std::string told(std::string why) {
  const std::string made_up = "$$$___magic___$$$.";
  for (std::size_t at = why.find(made_up); at != std::string::npos; at = why.find(made_up))
    why.replace(at, made_up.size(), "a file of ending ");
  for (char& c : why)
    if (c < ' ' || c > '~') c = ' ';
  return why;
}

TriangleSoup read_by_assimp(const std::string& bytes, const std::string& format) {
  TriangleSoup soup;
  Assimp::Importer importer;
  const aiScene* scene = nullptr;
  std::string why;
  try {
    scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(),
                                        aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_PreTransformVertices,
                                        format.c_str());
    why = importer.GetErrorString();
  } catch (const std::exception& e) {
    why = e.what();
  }
  if (!scene) throw InvalidValue("", "a " + format + " mesh", "one that cannot be read: " + told(why));
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) append_mesh(*scene->mMeshes[i], {}, soup);
  return soup;
}

}  // namespace

TriangleSoup read_mesh_file(const std::string& bytes, const std::string& format) {
  if (format == "stl") check_stl(bytes);
  TriangleSoup soup = format == "ply"   ? read_ply(bytes)
                      : format == "obj" ? read_obj(bytes)
                                        : read_by_assimp(bytes, format);
  if (soup.triangles.empty()) throw InvalidValue("", "a mesh with triangles", "none");
  return soup;
}

}  // namespace graze::io
