# SPDX-License-Identifier: BSD-3-Clause
# Debian 12 with its own ROS and this package, built:
#   docker build -t line_plane_segmentation .
#   docker run --rm -it line_plane_segmentation                  # the demo, as text
#   docker run --rm -it line_plane_segmentation scripts/test     # all tests
#   docker run --rm -it --net=host line_plane_segmentation bash  # with the workspace sourced, for a robot's network
FROM debian:bookworm

WORKDIR /line_plane_segmentation

# The packages change seldom: they are a layer of their own.
COPY scripts/install_dependencies scripts/
RUN scripts/install_dependencies && rm -rf /var/lib/apt/lists/*

COPY . .
RUN scripts/build

ENTRYPOINT ["/line_plane_segmentation/scripts/docker_entry"]
CMD ["scripts/demo"]
