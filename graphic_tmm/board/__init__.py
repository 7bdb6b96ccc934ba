"""The drawing board: of packages numpy, llvmlite in `compile`; knows no mechanism, scene or paper."""
