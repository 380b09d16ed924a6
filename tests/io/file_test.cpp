// Files written as a whole: the old bytes or all of the new ones.
#include "graze/io/file.hpp"

#include <gtest/gtest.h>

#include <iterator>

#include "graze/error.hpp"

namespace graze::io {

namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A folder of its own, gone with the test.
struct WholeFiles : ::testing::Test {
  WholeFiles()
      : folder(fs::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~WholeFiles() override { fs::remove_all(folder); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  fs::path folder;
};

/// The reason of the error that `f` throws.
template <class F>
std::string reason_of(F&& f) {
  try {
    f();
  } catch (const InvalidValue& e) {
    return e.what();
  }
  return "nothing thrown";
}

TEST_F(WholeFiles, HaveTheirOldBytesUntilTheyAreClosed) {
  const fs::path file = folder / "a.txt";
  write_file(file, "old");
  WholeFileWriter out(file);
  out.write("new, ");
  out.write(std::string(1 << 20, 'x'));
  EXPECT_EQ(bytes_of(file), "old");
  out.close();
  EXPECT_EQ(bytes_of(file), "new, " + std::string(1 << 20, 'x'));
  EXPECT_EQ(files(), 1U);
}

TEST_F(WholeFiles, AreNotThereWhereTheirWriterEndsEarly) {
  const fs::path kept = folder / "kept.txt";
  write_file(kept, "old");
  { WholeFileWriter(kept).write("half"); }
  { WholeFileWriter(folder / "new.txt").write("half"); }
  EXPECT_EQ(bytes_of(kept), "old");
  EXPECT_EQ(files(), 1U);
}

TEST_F(WholeFiles, AreWrittenThroughLinks) {
  write_file(folder / "there.txt", "old");
  fs::create_symlink("there.txt", folder / "link");
  fs::create_symlink("link", folder / "link to link");
  write_file(folder / "link to link", "new");
  EXPECT_EQ(bytes_of(folder / "there.txt"), "new");
  fs::create_symlink(folder / "not there.txt", folder / "loose");
  write_file(folder / "loose", "made");
  EXPECT_EQ(bytes_of(folder / "not there.txt"), "made");
  for (const char* link : {"link", "link to link", "loose"}) EXPECT_TRUE(fs::is_symlink(folder / link)) << link;
  EXPECT_EQ(files(), 5U);
}

TEST_F(WholeFiles, ALinkOfThePartialNameIsNotFollowed) {
  write_file(folder / "precious.txt", "kept");
  fs::create_symlink("precious.txt", folder / "a.txt.partial");
  write_file(folder / "a.txt", "new");
  EXPECT_EQ(bytes_of(folder / "precious.txt"), "kept");
  EXPECT_EQ(bytes_of(folder / "a.txt"), "new");
  EXPECT_FALSE(fs::is_symlink(folder / "a.txt"));
}

TEST_F(WholeFiles, KeepThePermissionsOfWhatWasThere) {
  const fs::path file = folder / "secret.txt";
  write_file(file, "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  write_file(file, "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(WholeFiles, DevicesStayDevices) {
  if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full";
  EXPECT_NO_THROW(write_file("/dev/null", "nothing"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  fs::create_symlink("/dev/full", folder / "full");
  for (const fs::path& full : {fs::path("/dev/full"), folder / "full"})
    EXPECT_EQ(reason_of([&] { write_file(full, "some"); }),
              full.string() + ": cannot be written: no space left on device");
  EXPECT_EQ(files(), 1U);
}

TEST_F(WholeFiles, AreMadeInMemoryToo) {
  const fs::path memory = "/dev/shm";
  if (!fs::is_directory(memory)) GTEST_SKIP() << "no file system in memory";
  const fs::path file = memory / ("graze_" + folder.filename().string());
  fs::remove(file);
  check_writable(file);
  EXPECT_FALSE(fs::exists(file));
  write_file(file, "made");
  EXPECT_EQ(bytes_of(file), "made");
  fs::remove(file);
}

TEST_F(WholeFiles, WhatCannotBeWrittenIsNamed) {
  const fs::path nowhere = folder / "nowhere" / "a.txt";
  const std::string no_folder = nowhere.string() + ": cannot be written: no such folder";
  EXPECT_EQ(reason_of([&] { write_file(nowhere, "some"); }), no_folder);
  EXPECT_EQ(reason_of([&] { check_writable(nowhere); }), no_folder);
  EXPECT_EQ(reason_of([&] { write_file(folder, "some"); }), folder.string() + ": cannot be written: is a directory");
}

TEST_F(WholeFiles, CheckingLeavesEverythingAsItWas) {
  check_writable(folder / "a.txt");
  EXPECT_EQ(files(), 0U);
  write_file(folder / "a.txt", "old");
  check_writable(folder / "a.txt");
  EXPECT_EQ(bytes_of(folder / "a.txt"), "old");
  EXPECT_EQ(files(), 1U);
}

}  // namespace

}  // namespace graze::io
