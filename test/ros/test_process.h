// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpc.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace line_plane_segmentation {

/// Process id of a node, -1 if there is none.
inline int processOfNode(const std::string& node) {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  request[1] = node;
  if (!ros::master::execute("lookupNode", request, response, payload, false)) return -1;

  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(std::string(payload), host, port)) return -1;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port));
  XmlRpc::XmlRpcValue caller, pid;
  caller[0] = ros::this_node::getName();
  return client.execute("getPid", caller, pid) ? static_cast<int>(pid[2]) : -1;
}

/// Process id of the node that publishes a topic, -1 if there is none.
inline int processThatPublishes(const std::string& topic) {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, payload, false)) return -1;
  for (int i = 0; i < payload[0].size(); ++i) {
    if (std::string(payload[0][i][0]) == topic) return processOfNode(payload[0][i][1][0]);
  }
  return -1;
}

/// Resident memory of a process [MB], 0 if it does not exist.
inline double residentMegabytes(int process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  double total_pages = 0.0, resident_pages = 0.0;
  file >> total_pages >> resident_pages;
  return resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Number of entries of a folder in /proc/PID: threads for `task`, open files for `fd`. 0 if the process
/// does not exist.
inline int entriesOf(int process, const std::string& folder) {
  std::error_code ignored;
  const std::filesystem::directory_iterator entries("/proc/" + std::to_string(process) + '/' + folder,
                                                    ignored);
  return static_cast<int>(std::distance(begin(entries), end(entries)));
}

/// Processor time of a process [s], 0 if it does not exist.
inline double processorSeconds(int process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return 0.0;
  std::istringstream fields(text.substr(name_end + 1));
  constexpr int kFieldsBefore = 11;  // between the name and utime
  std::string skipped;
  for (int i = 0; i < kFieldsBefore; ++i) fields >> skipped;
  double user_ticks = 0.0, system_ticks = 0.0;
  fields >> user_ticks >> system_ticks;
  return (user_ticks + system_ticks) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace line_plane_segmentation
