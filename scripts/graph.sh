# SPDX-License-Identifier: BSD-3-Clause
# Sourced after common.sh: one launch file at a time, under a ROS master of its own, which ends with the script.

# show_progress: how far ninja has come, by its [done/all]: in place on a terminal, a line each tenth elsewhere.
show_progress() {
  local word shown=-1 percent end=$'\n' step=10
  [ -t 1 ] && end=$'\r' step=1
  while read -r word _; do
    [[ $word =~ ^\[([0-9]+)/([0-9]+)\]$ ]] || continue
    [ "${BASH_REMATCH[2]}" -gt 9 ] || continue  # ninja looks about before it begins
    percent=$((100 * BASH_REMATCH[1] / BASH_REMATCH[2] / step * step))
    [ "$percent" -eq "$shown" ] || printf 'built: %d %%%s' "$percent" "$end"
    shown=$percent
  done
  [ "$step" -eq 10 ] || echo
}

build_workspace() {
  "$root/scripts/setup"
  mkdir -p "$build/stages"
  echo 'building (the first time takes ten to twenty minutes on two cores)'
  "$root/scripts/build" 2>&1 | tee "$build/stages/build.log" | show_progress || {
    tail -n 40 "$build/stages/build.log"
    exit 1
  }
  set +u
  source "$root/devel/setup.bash"
  set -u
}

# start_graph LOG ARGUMENT...: roslaunch with these arguments, in the background.
start_graph() {
  local log=$1 port
  shift
  port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
  export ROS_MASTER_URI="http://localhost:$port" ROS_HOSTNAME=localhost ROS_HOME="$build/ros_home"
  roslaunch -p "$port" "$@" > "$log" 2>&1 &
  graph=$!
  trap stop_graph EXIT
  timeout 60 bash -c 'until rosparam list > /dev/null 2>&1; do sleep 0.2; done' || {
    echo "no ROS master came up; see $log" >&2
    exit 1
  }
}

stop_graph() {
  kill -INT "$graph" 2> /dev/null || true
  wait "$graph" 2> /dev/null || true
  trap - EXIT
}

# call SERVICE: a std_srvs/Trigger that has to succeed.
call() {
  local answer
  answer=$(rosservice call --wait "$1")
  grep -q 'success: True' <<< "$answer" || {
    echo "$1: $answer" >&2
    exit 1
  }
}
