// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpc.h>

#include <fstream>
#include <string>

namespace line_plane_segmentation {

/// The process of the node that publishes a topic. -1 if there is none.
inline int processThatPublishes(const std::string& topic) {
  XmlRpc::XmlRpcValue request, response, payload, node;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, payload, false)) return -1;
  for (int i = 0; i < payload[0].size(); ++i) {
    if (std::string(payload[0][i][0]) == topic) node = payload[0][i][1][0];
  }
  request[1] = node;
  if (!node.valid() || !ros::master::execute("lookupNode", request, response, payload, false)) return -1;

  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(std::string(payload), host, port)) return -1;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port));
  XmlRpc::XmlRpcValue caller, pid;
  caller[0] = ros::this_node::getName();
  return client.execute("getPid", caller, pid) ? static_cast<int>(pid[2]) : -1;
}

/// Memory [MB] that a process has in use. 0 if there is no such process.
inline double residentMegabytes(int process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  double total_pages = 0.0, resident_pages = 0.0;
  file >> total_pages >> resident_pages;
  return resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

}  // namespace line_plane_segmentation
