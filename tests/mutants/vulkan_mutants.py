# SPDX-License-Identifier: MIT
"""Deliberate faults of the Vulkan backend. Mesa's renderer answers rightly without barriers: the validation layer sees them."""
from mutant import mutant

VULKAN = [
    mutant("dispatches wait for none before", "vulkan/launches.cpp", "if (!one.early) kernel_barrier(vk_, commands);", "", "Vulkan"),
    mutant("damaged SPIR-V is read", "vulkan/spirv/module_files.cpp", "if (digest_of(code) != written ||", "if (", "Vulkan"),
    mutant("SPIR-V is compiled although it was kept", "vulkan/spirv/module_files.cpp", "if (words.empty()) write_words",
           "write_words", "Vulkan"),
    mutant("SPIR-V is kept without a folder for it", "vulkan/spirv/module_files.cpp", "if (folder.empty()) return compile();", "", "Vulkan"),
    mutant("a transfer waits for no kernel", "vulkan/staging.cpp", "  barrier_before_transfer(vk_, commands);\n", "", "Vulkan"),
    mutant("kernels do not wait for a transfer", "vulkan/staging.cpp", "  barrier_behind_transfer(vk_, commands);\n", "", "Vulkan"),
    mutant("slices are used again while they are read", "vulkan/launches.cpp",
           "  stream_.wait();\n  stages_.collect();\n  forget_buffers();", "  bindings_.slices.forget();", "Vulkan"),
    mutant("a descriptor set is that of other buffers", "vulkan/descriptor_sets.cpp", "if (set.texels == texels &&", "if (true ||",
           "Methods", "Vulkan"),
    mutant("slots that a launch does not use are bound", "vulkan/vulkan_device.cpp", "left = launch.unused;", "left = 0;", "Vulkan"),
    mutant("the Vulkan device that is named is ignored", "vulkan/device/instance.cpp", "(wanted.empty() || named)", "(true || named)",
           "DeviceNames"),
    mutant("Vulkan runs in software where hardware is required", "vulkan/device/instance.cpp",
           "in_software(properties) && options.require_hardware", "false && options.require_hardware", "Vulkan"),
    mutant("a texel buffer longer than the device's", "vulkan/vulkan_device.cpp", "return wanted.value_or(true) && texels <= most;",
           "return wanted.value_or(true);", "Vulkan"),
]
