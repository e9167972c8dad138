// Mutated surface files: whatever the reader's library does with them, this process lives and says why not.

#include <gtest/gtest.h>

#include <random>

#include "common/anatomy/child_process.h"
#include "common/anatomy/import_reply.h"
#include "common/anatomy/surface_io.h"
#include "common/error.h"
#include "tests/anatomy/files.h"

namespace prosector {
namespace {

using namespace testing_files;

const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 4\nproperty list uchar int vertex_index\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const std::string off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

std::string complaint(const std::filesystem::path& file, double time_limit = 60) {
  try {
    load_surface(file, 1, {.time_limit = time_limit});
    return "";
  } catch (const InputError& e) {
    return e.what();
  }
}

TEST(SurfaceFuzz, MutatedFilesLoadOrAreRefused) {
  const TempDir dir;
  std::mt19937_64 random(20100611);
  constexpr double some_hang = 0.5;  // s
  int loaded = 0, refused = 0;
  for (const auto& [name, seed] :
       {std::pair("m.ply", &ply), std::pair("m.obj", &obj), std::pair("m.off", &off)})
    for (int n = 0; n < 12; ++n) {
      std::string text = *seed;
      for (std::uint64_t edits = 1 + random() % 3; edits > 0; --edits) {
        const std::size_t at = random() % text.size();
        if (random() % 2 == 0)
          text[at] = static_cast<char>('0' + random() % 10);
        else
          text.insert(at, text.substr(random() % text.size(), random() % 20));
      }
      write(dir.path / name, text);
      (complaint(dir.path / name, some_hang).empty() ? loaded : refused)++;
    }
  EXPECT_GT(loaded, 0);
  EXPECT_GT(refused, 0);
}

// A face without a number of corners, and a header without its end: Assimp's reader of PLY crashed and hung.
TEST(SurfaceFuzz, PlyFilesThatEndedTheirReaderAreRefusedInWords) {
  const TempDir dir;
  std::string text = ply;
  text[text.find("3 0 3 2")] = '\x0e';
  write(dir.path / "corners.ply", text);
  EXPECT_NE(complaint(dir.path / "corners.ply").find("expected: a list's length"), std::string::npos);
  text = ply;
  text[text.find("end_header") + 6] = 'q';
  write(dir.path / "header.ply", text);
  const std::string what = complaint(dir.path / "header.ply");
  EXPECT_NE(what.find("header.ply: not a surface (line 9: \"end_heqder\" found"), std::string::npos) << what;
  EXPECT_NE(what.find("allowed: OBJ, STL, PLY, OFF, glTF"), std::string::npos) << what;
}

TEST(SurfaceFuzz, AReaderThatTakesTooLongIsEnded) {
  const TempDir dir;
  write(dir.path / "slow.obj", obj);
  EXPECT_NE(
      complaint(dir.path / "slow.obj", 1e-6).find("its reader prosector-import timed out after 1e-06 s"),
      std::string::npos);
}

TEST(ChildProcess, EndsWithinItsLimitsAndSaysHow) {
  EXPECT_EQ(run_child("/bin/echo", {"a b"}, {10, 100}).error, "");
  const ChildOutcome said = run_child("/bin/echo", {"a b"}, {10, 100});
  EXPECT_EQ(std::string(said.output.begin(), said.output.end()), "a b\n");
  EXPECT_EQ(run_child("/bin/sh", {"-c", "exit 3"}, {10, 100}).error, "ended with exit code 3");
  EXPECT_EQ(run_child("/bin/sh", {"-c", "kill -ABRT $$"}, {10, 100}).error, "crashed (Aborted)");
  EXPECT_EQ(run_child("/bin/cat", {"/dev/zero"}, {10, 100}).error, "wrote more than 100 bytes");
  EXPECT_EQ(run_child("/bin/sleep", {"20"}, {0.1, 100}).error, "timed out after 0.1 s");
  EXPECT_EQ(run_child("/bin/cat", {"-"}, {10, 100}).error, "");  // nothing to read, at once
  EXPECT_NE(run_child("/nonexistent", {}, {10, 100}).error.find("cannot be started (No such file"),
            std::string::npos);
}

TEST(ImportReply, RoundTrips) {
  ImportReply reply;
  reply.mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(decode_import_reply(encode(reply)).mesh.triangles, reply.mesh.triangles);
  EXPECT_EQ(decode_import_reply(encode(reply)).mesh.positions, reply.mesh.positions);
  EXPECT_EQ(decode_import_reply(encode({{}, "no"})).refusal, "no");
  reply.notes = {"one", "two"};
  EXPECT_EQ(decode_import_reply(encode(reply)).notes, reply.notes);
}

TEST(ImportReply, MutatedRepliesAreReadOrRefused) {
  ImportReply reply;
  reply.mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  const Bytes whole = encode(reply);
  std::mt19937_64 random(20100611);
  int read = 0, refused = 0;
  for (int n = 0; n < 20000; ++n) {
    Bytes bytes = whole;
    for (std::uint64_t edits = random() % 3; edits > 0; --edits)
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    if (random() % 4 == 0) bytes.resize(random() % (bytes.size() + 1));
    try {
      const TriangleMesh mesh = decode_import_reply(bytes).mesh;
      for (const auto& t : mesh.triangles)
        for (const auto v : t) ASSERT_LT(v, mesh.positions.size());
      ++read;
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(read, 1000);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace prosector
