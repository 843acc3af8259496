# SPDX-License-Identifier: MIT
# What check, reproduce and .ci/sanitize share; sourced by each from the root of the project.

build_packages="g++ cmake ninja-build pkg-config libepoxy-dev libegl-dev libegl1 libegl-mesa0 libgl1-mesa-dri
  libcli11-dev nlohmann-json3-dev libfmt-dev libboost-dev libglm-dev libpng-dev zlib1g-dev libglfw3-dev libimgui-dev libgl1
  libvulkan-dev libvulkan1 mesa-vulkan-drivers glslang-dev glslang-tools spirv-tools"
test_packages="libbenchmark-dev libgtest-dev libgmp-dev librapidcheck-dev vulkan-validationlayers
  clang-format python3 xvfb xauth"
sanitize_packages="clang-16 libclang-rt-16-dev libomp-16-dev llvm-16" # clang 14 cannot compile the views of GCC 12
figure_packages="cmake python3-matplotlib python3-scipy" # cmake: whether records are of the current sources
paper_packages="latexmk texlive-latex-base texlive-latex-recommended texlive-fonts-recommended"

say() { printf '\n== %s\n' "$*"; }
fail() {
  printf '%s\n' "$*" >&2
  exit 1
}

# Whether --help or -h is among the arguments.
asks_for_help() {
  local word
  for word in "$@"; do
    case $word in --help | -h) return 0 ;; esac
  done
  return 1
}

missing_packages() {
  for package in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || echo "$package"
  done
}

# Installs what is missing of the packages named; on a system without apt-get it only names them.
install_packages() {
  if ! command -v apt-get >/dev/null; then
    echo "There is no apt-get here, so nothing is installed. Needed, by their Debian names: $*"
    return
  fi
  if [ "${INSTALL:-yes}" = no ]; then
    echo "INSTALL=no: nothing is installed"
    return
  fi
  local missing root=""
  missing=$(missing_packages "$@" | xargs)
  if [ -z "$missing" ]; then
    echo "Every package needed is installed."
    return
  fi
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null || fail "These packages are missing and only an administrator can install them:" \
      "apt-get install $missing" "(INSTALL=no goes on without them, where they came by another way)"
    root="sudo"
  fi
  echo "Installing: $missing"
  $root apt-get -q update || echo "apt-get update failed; going on with the package lists that are here." >&2
  # shellcheck disable=SC2086 # a list of words
  $root env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install $missing ||
    fail "apt-get could not install: $missing"
}

# Prints the path of nvcc, or nothing.
find_nvcc() { command -v nvcc || ls "${CUDA_HOME:-/usr/local/cuda}/bin/nvcc" 2>/dev/null || true; }

# Prints a python3 that has matplotlib and scipy (another one may come first in PATH), or nothing.
find_python() {
  local python
  for python in python3 /usr/bin/python3; do
    "$python" -c 'import matplotlib, scipy' 2>/dev/null && echo "$python" && return
  done
  return 0
}

# The compute capability of the first GPU as nvcc writes it (90), or nothing without a working driver.
gpu_architecture() {
  { nvidia-smi --query-gpu=compute_cap --format=csv,noheader 2>/dev/null || true; } | head -n 1 | tr -dc 0-9
}
