# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the scripts beside it: where things are, and an environment that pyenv or conda cannot bend.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$root/build"
jobs=${PORTOLAN_JOBS:-$(nproc)}

# ROS is built for the system's python3, so that one has to be found first.
export PATH="/usr/bin:/bin:/usr/sbin:/sbin:$PATH"
unset PYTHONHOME PYTHONPATH
if [ -f /opt/ros/noetic/setup.bash ]; then
  set +u
  source /opt/ros/noetic/setup.bash
  set -u
fi

compiler_launcher=()
if command -v ccache > /dev/null; then
  compiler_launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi

# A build in which sanitizers can name lines, and which is not too slow for them.
watched=(-DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1")

# cpp_files: every C++ file of ours, one a line, relative to the root.
cpp_files() {
  (cd "$root" && find src \( -name '*.cpp' -o -name '*.hpp' \) -type f | sort)
}

# build_core_without_ros DIR [CMAKE_ARGUMENT...]: configures, builds and tests the core in DIR as a plain CMake
# project, in an environment in which nothing points at ROS.
build_core_without_ros() {
  local dir=$1
  shift
  local plain=(env -u ROS_DISTRO -u ROS_ROOT -u ROS_PACKAGE_PATH -u CMAKE_PREFIX_PATH -u LD_LIBRARY_PATH
    -u PKG_CONFIG_PATH)
  "${plain[@]}" cmake -S "$root/src/portolan_core" -B "$dir" -G Ninja \
    -DCMAKE_DISABLE_FIND_PACKAGE_catkin=ON -DPORTOLAN_WERROR=ON "${compiler_launcher[@]}" "$@"
  "${plain[@]}" cmake --build "$dir" -j "$jobs"
  (cd "$dir" && "${plain[@]}" ctest -j "$jobs" --output-on-failure)
}

# build_aside DIR [ARGUMENT...]: the workspace once more in DIR, without tests, for a tool that looks at it while it runs.
# Arguments go to catkin_make.
build_aside() {
  local dir=$1
  shift
  catkin_make -C "$root" --use-ninja --build "$dir" -j "$jobs" -DCATKIN_DEVEL_PREFIX="$dir/devel" \
    -DCATKIN_ENABLE_TESTING=OFF "${watched[@]}" \
    -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 "${compiler_launcher[@]}" "$@"
}
