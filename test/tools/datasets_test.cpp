// SPDX-License-Identifier: BSD-3-Clause
#include "datasets.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "run_tool.h"
#include "temporary_folder.h"

namespace line_plane_segmentation {
namespace {

using Names = std::vector<std::string>;

class Datasets : public testing::Test {
 protected:
  void touch(const std::string& file) const {
    std::filesystem::create_directories((folder_ / file).parent_path());
    folder_.write(file, "");
  }

  std::vector<DepthFrame> frames(const std::string& dataset, const std::string& sequence) const {
    return framesOfDataset(dataset, folder_ / sequence, std::nullopt, std::nullopt);
  }

  static Names namesOf(const std::vector<DepthFrame>& frames) {
    Names names;
    for (const DepthFrame& frame : frames) names.push_back(frame.name);
    return names;
  }

  void expectRefused(const std::string& dataset, const std::string& sequence,
                     const std::string& reason) const {
    try {
      frames(dataset, sequence);
      FAIL() << "took " << sequence;
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }

  TemporaryFolder folder_;
};

TEST_F(Datasets, ScanNetHasItsIntrinsicsBesideTheImages) {
  for (const char* name : {"10", "2", "0"}) touch(std::string("scene0000_00/depth/") + name + ".png");
  touch("scene0000_00/color.png");
  expectRefused("scannet", "scene0000_00", "there is no intrinsic/intrinsic_depth.txt; give --camera");
  std::filesystem::create_directory(folder_ / "scene0000_00/intrinsic");
  const std::string file = "scene0000_00/intrinsic/intrinsic_depth.txt";
  folder_.write(file, "577.870605 0.000000 319.500000 0.000000\n0.0 577.5 239.5 0.0\n0 0 1 0\n0 0 0 1\n");
  const auto all = frames("scannet", "scene0000_00");
  EXPECT_EQ(namesOf(all), (Names{"0", "2", "10"}));
  EXPECT_EQ(all[0].camera.fx, 577.870605);
  EXPECT_EQ(all[0].camera.fy, 577.5);
  EXPECT_EQ(all[0].camera.cx, 319.5);
  EXPECT_EQ(all[0].camera.cy, 239.5);
  EXPECT_EQ(all[0].depth_unit, 0.001);
  folder_.write(file, "577.870605 0.000000");
  expectRefused("scannet", "scene0000_00", "is not a matrix");
}

TEST_F(Datasets, TakesOtherFormatsOfAFolderWithoutPngs) {
  touch("arrays/b.npy");
  touch("arrays/a.npy");
  touch("arrays/notes.txt");
  EXPECT_EQ(imagesIn(folder_ / "arrays"), (Names{folder_ / "arrays/a.npy", folder_ / "arrays/b.npy"}));
  touch("arrays/c.png");
  EXPECT_EQ(imagesIn(folder_ / "arrays"), (Names{folder_ / "arrays/c.png"}));
}

TEST_F(Datasets, TumHasACameraForEachFreiburg) {
  const double fx[] = {517.3, 520.9, 535.4};
  for (int i = 1; i <= 3; ++i) {
    const std::string sequence = "rgbd_dataset_freiburg" + std::to_string(i) + "_desk";
    touch(sequence + "/depth/1305031453.374112.png");
    touch(sequence + "/depth/1305031452.404816.png");
    touch(sequence + "/rgb/1305031452.404816.png");
    touch(sequence + "/depth.txt");
    for (const std::string& spelling : {sequence, sequence + "/"}) {
      const auto all = frames("tum", spelling);
      EXPECT_EQ(namesOf(all), (Names{"1305031452.404816", "1305031453.374112"}));
      EXPECT_EQ(all[0].camera.fx, fx[i - 1]);
      EXPECT_EQ(all[0].depth_unit, 0.0002);
      EXPECT_EQ(all[1].image.parent_path().filename(), "depth");
    }
  }
  touch("desk/depth/1.png");
  expectRefused("tum", "desk", "which camera took 'desk'?");
  touch("fr2_desk/depth/1.png");
  EXPECT_EQ(frames("tum", "fr2_desk")[0].camera.fy, 521.0);
}

TEST_F(Datasets, IclNuimCountsWithoutLeadingZeros) {
  for (const char* name : {"10", "2", "1", "100"}) touch("traj0/depth/" + std::string(name) + ".png");
  const auto all = frames("icl_nuim", "traj0");
  EXPECT_EQ(namesOf(all), (Names{"1", "2", "10", "100"}));
  EXPECT_EQ(all[0].camera.fx, 481.2);
  EXPECT_EQ(all[0].camera.fy, 480.0);
  EXPECT_EQ(all[0].depth_unit, 0.0002);
}

TEST_F(Datasets, NyuTakesTheDepthFromAmongTheColourImages) {
  touch("kitchen/rgb_00000.png");
  touch("kitchen/sync_depth_00001.png");
  touch("kitchen/sync_depth_00000.png");
  const auto all = frames("nyu", "kitchen");
  EXPECT_EQ(namesOf(all), (Names{"sync_depth_00000", "sync_depth_00001"}));
  EXPECT_NEAR(all[0].camera.fx, 518.858, 0.001);
  EXPECT_EQ(all[0].depth_unit, 0.001);
  touch("test/depth/0007.png");
  EXPECT_EQ(namesOf(frames("nyu", "test")), Names{"0007"});
}

TEST_F(Datasets, SevenScenesHave65535WhereThereIsNoDepth) {
  touch("seq-01/frame-000001.color.png");
  touch("seq-01/frame-000001.pose.txt");
  std::filesystem::create_directories(folder_ / "seq-01");
  cv::Mat depth(2, 3, CV_16UC1, cv::Scalar(1500));
  depth.at<std::uint16_t>(1, 2) = 65535;
  cv::imwrite((folder_ / "seq-01/frame-000001.depth.png").string(), depth);
  const auto all = frames("7scenes", "seq-01");
  ASSERT_EQ(namesOf(all), Names{"frame-000001"});
  EXPECT_EQ(all[0].camera.fx, 585.0);
  const cv::Mat read = readDepth(all[0]);
  EXPECT_EQ(read.at<std::uint16_t>(1, 2), 0);
  EXPECT_EQ(read.at<std::uint16_t>(1, 1), 1500);
}

TEST_F(Datasets, YieldToWhatTheUserKnowsBetter) {
  touch("somewhere/depth/1.png");
  const auto all = framesOfDataset("tum", folder_ / "somewhere", CameraIntrinsics{500, 501, 320, 240}, 0.005);
  EXPECT_EQ(all.at(0).camera.fy, 501);
  EXPECT_EQ(all.at(0).depth_unit, 0.005);
}

TEST_F(Datasets, RefuseWhatIsNotThere) {
  touch("freiburg1/rgb/1.png");
  expectRefused("tum", "freiburg1", "there is no *.png, nor in its depth/");
  expectRefused("tum", "nowhere", "nowhere: no such folder");
  expectRefused("kitti", "freiburg1", "there are tum, icl_nuim, nyu, 7scenes and scannet");
  touch("seq-02/frame-000001.color.png");
  expectRefused("7scenes", "seq-02", "there is no *.depth.png");
}

TEST_F(Datasets, PlainFoldersGiveTheirImagesButNoResults) {
  for (const char* name :
       {"b.png", "a9.png", "a10.png", "a9.labels.png", "a9.overlay.png", ".a.png", "a.txt"}) {
    touch("plain/" + std::string(name));
  }
  Names names;
  for (const std::filesystem::path image : imagesIn(folder_ / "plain"))
    names.push_back(image.filename().string());
  EXPECT_EQ(names, (Names{"a9.png", "a10.png", "b.png"}));
}

}  // namespace
}  // namespace line_plane_segmentation
