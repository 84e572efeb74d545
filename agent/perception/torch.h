// SPDX-License-Identifier: MIT
#pragma once
// The parts of torch that are used here. They take half of torch/torch.h's ten seconds to read; not
// for headers that other folders include.
#include <ATen/ATen.h>
#include <ATen/Parallel.h>
#include <torch/csrc/autograd/generated/variable_factories.h>
#include <torch/nn/module.h>
#include <torch/types.h>
