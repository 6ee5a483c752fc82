// Each bar of the fence around GDAL by itself: one that is missing does not show as long as another
// holds.

#include <arpa/inet.h>
#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>

#include "profiles/gdal_handle.hpp"
#include "profiles/register_dem.hpp"
#include "tests/profiles/drawn_dem.hpp"

namespace leda::profiles {
namespace {

namespace fs = std::filesystem;
using test::drawn;
using test::TestFolder;
using test::write_geotiff;

/// A port of this machine where nobody answers, and that knows whether somebody came.
class Listener {
 public:
  Listener() : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    address_.sin_family = AF_INET;
    address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address_);
    EXPECT_EQ(bind(socket_, reinterpret_cast<sockaddr*>(&address_), size), 0);
    listen(socket_, 8);
    getsockname(socket_, reinterpret_cast<sockaddr*>(&address_), &size);
  }
  ~Listener() { close(socket_); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  std::string url() const {
    return "http://127.0.0.1:" + std::to_string(ntohs(address_.sin_port)) + "/dem.tif";
  }
  bool somebody_came() const {
    pollfd one{socket_, POLLIN, 0};
    return poll(&one, 1, 200) > 0;
  }

 private:
  int socket_;
  sockaddr_in address_{};
};

TEST(GdalFence, TheNetworkStaysOutAlsoWhereANameGetsPastTheDoor) {
  initialize_gdal();
  const Listener network;
  // With a limit on time, so that a bar that is missing shows as a failure and not as a wait.
  CPLSetConfigOption("GDAL_HTTP_TIMEOUT", "2");
  CPLSetConfigOption("GDAL_HTTP_CONNECTTIMEOUT", "2");
  for (const std::string& name :
       {"/vsicurl/" + network.url(), "/vsicurl_streaming/" + network.url(),
        "/vsicurl?max_retry=0&url=" + network.url(), "/vsiwebhdfs/" + network.url(),
        std::string("/vsis3/bucket/dem.tif")}) {
    EXPECT_EQ(GDALOpenEx(name.c_str(), GDAL_OF_RASTER, nullptr, nullptr, nullptr), nullptr) << name;
    VSIStatBufL stat;
    EXPECT_NE(VSIStatL(name.c_str(), &stat), 0) << name;
  }
  EXPECT_FALSE(network.somebody_came());
}

TEST(GdalFence, DriversThatCouldReadAFileAreNotAskedUnlessTheyAreForElevations) {
  const TestFolder folder;
  const fs::path tif = write_geotiff(drawn({"11", "12"}), folder / "in.tif");
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("PNG");
  ASSERT_NE(driver, nullptr) << "the test needs a driver that is not on the list";
  const DatasetHandle opened(GDALDataset::Open(tif.c_str(), GDAL_OF_RASTER));
  GDALDataset* copy = driver->CreateCopy((folder / "dem.tif").c_str(), opened.get(), FALSE, nullptr,
                                         nullptr, nullptr);
  ASSERT_NE(copy, nullptr);
  GDALClose(GDALDataset::ToHandle(copy));
  const DatasetHandle readable(GDALDataset::Open((folder / "dem.tif").c_str(), GDAL_OF_RASTER));
  EXPECT_NE(readable, nullptr) << "GDAL itself would read it";
  EXPECT_THROW(Dem::open(folder / "dem.tif"), DemError);
}

TEST(GdalFence, NoFileSystemButThoseOfThisMachineIsLeft) {
  initialize_gdal();
  const CPLStringList prefixes(VSIGetFileSystemsPrefixes());
  int elsewhere = 0;
  for (int i = 0; i < prefixes.size(); ++i) {
    const std::string prefix = prefixes[i];
    if (prefix.find("mem") != std::string::npos || prefix.find("zip") != std::string::npos ||
        prefix.find("sub") != std::string::npos || prefix.find("sparse") != std::string::npos)
      continue;
    ++elsewhere;
    errno = 0;
    EXPECT_EQ(VSIFOpenL((prefix + "a/b").c_str(), "rb"), nullptr) << prefix;
    EXPECT_EQ(errno, ENOENT) << prefix;
  }
  EXPECT_GT(elsewhere, 10);
}

TEST(GdalFence, WhatLiesBesideAFileSaysNothingAboutIt) {
  const TestFolder folder;
  const fs::path tif = write_geotiff(drawn({"11", "12"}), folder / "dem.tif");
  std::ofstream(folder / "dem.tif.aux.xml")
      << "<PAMDataset><PAMRasterBand band=\"1\"><NoDataValue>1</NoDataValue>"
         "<UnitType>ft</UnitType></PAMRasterBand></PAMDataset>";
  const auto dem = register_dem(tif, folder / "out.tif");
  EXPECT_EQ(dem.info.vertical_unit, "m");
  EXPECT_DOUBLE_EQ(dem.share_with_data, 1);
  EXPECT_FALSE(fs::exists(folder / "out.tif.aux.xml"));
}

TEST(GdalFence, EveryOptionIsSet) {
  initialize_gdal();
  const auto option = [](const char* name) { return std::string(CPLGetConfigOption(name, "")); };
  EXPECT_EQ(option("CPL_VSIL_CURL_ALLOWED_FILENAME"), "none");
  EXPECT_EQ(option("GDAL_DISABLE_READDIR_ON_OPEN"), "EMPTY_DIR");
  EXPECT_EQ(option("GDAL_PAM_ENABLED"), "NO");
  EXPECT_EQ(option("GDAL_VRT_ENABLE_PYTHON"), "NO");
  for (const char* driver : {"VRT", "OGR_VRT", "HTTP", "WMS", "WCS", "WFS", "OAPIF", "OGCAPI",
                             "STACIT", "STACTA", "DERIVED", "PDF"}) {
    EXPECT_EQ(GetGDALDriverManager()->GetDriverByName(driver), nullptr) << driver;
  }
  EXPECT_LE(GDALGetCacheMax64(), GIntBig{128} << 20);
}

}  // namespace
}  // namespace leda::profiles
