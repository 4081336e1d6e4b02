#!/usr/bin/env python3
"""Makes the HDF5 files beside it, with the C library as other codes use it: python3 tests/data/make.py (needs h5py).

With `read FILE` it prints instead what h5py finds in a file, as JSON: tests/command/compare.rs holds our files against that.
"""

import json
import pathlib
import sys

import h5py
import numpy as np

HERE = pathlib.Path(__file__).parent


def header(file, count, **more):
    group = file.create_group("Header")
    for name, value in {
        "NumPart_ThisFile": np.array([count, 0, 0, 0, 0, 0], dtype=np.int32),
        "NumPart_Total": np.array([count, 0, 0, 0, 0, 0], dtype=np.uint32),
        "MassTable": np.zeros(6),
        "BoxSize": 1.0,
        "NumFilesPerSnapshot": 1,
        **more,
    }.items():
        group.attrs[name] = value


def gadget():
    """As GADGET-2 writes: the oldest format of HDF5, single precision, 32-bit ids, Hsml."""
    with h5py.File(HERE / "gadget.hdf5", "w", libver="earliest") as file:
        header(file, 3, Time=0.25, MassTable=np.array([0.5, 0, 0, 0, 0, 0]))
        gas = file.create_group("PartType0")
        gas["Coordinates"] = np.array([[0.125, 0.25, 0.5], [0.5, 0.75, 0.25], [0.75, 0.5, 0.125]], dtype=np.float32)
        gas["Velocities"] = np.array([[1, 0, 0], [0, 2, 0], [0, 0, 3]], dtype=np.float32)
        gas["ParticleIDs"] = np.array([3, 1, 2], dtype=np.uint32)
        gas["InternalEnergy"] = np.array([1.5, 2.5, 3.5], dtype=np.float32)
        gas["Density"] = np.array([1, 2, 4], dtype=np.float32)
        gas["Hsml"] = np.array([0.25, 0.5, 0.125], dtype=np.float32)


def swift():
    """As SWIFT writes: groups in the newer format, chunks that are shuffled and compressed, plural names, a box of three sides."""
    with h5py.File(HERE / "swift.hdf5", "w", libver=("v108", "v110")) as file:
        header(file, 3, Time=np.array([0.25]), BoxSize=np.array([1.0, 1.0, 1.0]), Dimension=np.array([2]))
        gas = file.create_group("PartType0")
        options = {"chunks": True, "compression": "gzip", "shuffle": True, "fletcher32": True}
        gas.create_dataset("Coordinates", data=np.array([[0.125, 0.25, 0], [0.5, 0.75, 0], [0.75, 0.5, 0]]), **options)
        gas.create_dataset("Velocities", data=np.array([[1, 0, 0], [0, 2, 0], [3, 0, 0]], dtype=np.float32), **options)
        gas.create_dataset("Masses", data=np.array([0.5, 0.5, 0.5], dtype=np.float32), **options)
        gas.create_dataset("ParticleIDs", data=np.array([3, 1, 2], dtype=np.uint64), **options)
        gas.create_dataset("InternalEnergies", data=np.array([1.5, 2.5, 3.5], dtype=np.float32), **options)
        gas.create_dataset("Densities", data=np.array([1, 2, 4], dtype=np.float32), **options)
        gas.create_dataset("SmoothingLengths", data=np.array([0.25, 0.5, 0.125], dtype=np.float32), **options)


def absurd():
    """Two datasets that claim 10^18 numbers and have none: a contiguous one and one in chunks. A reader must not believe them."""
    for name, options in {"absurd": {}, "absurd_chunks": {"chunks": (1024, 3), "compression": "gzip"}}.items():
        with h5py.File(HERE / f"{name}.hdf5", "w", libver="earliest") as file:
            header(file, 0, NumPart_Total=np.array([2**32 - 1, 0, 0, 0, 0, 0], dtype=np.uint32))
            gas = file.create_group("PartType0")
            gas.create_dataset("Coordinates", shape=(10**18 // 3, 3), dtype=np.float32, **options)


def read(path):
    with h5py.File(path, "r") as file:
        header = {name: np.asarray(value).tolist() for name, value in file["Header"].attrs.items()}
        gas = {name: data[...].tolist() for name, data in file["PartType0"].items()}
        units = {name: data.attrs["Unit"] for name, data in file["PartType0"].items() if "Unit" in data.attrs}
        units = {name: unit.decode() if isinstance(unit, bytes) else unit for name, unit in units.items()}
        print(json.dumps({"header": header, "gas": gas, "units": units}))


if __name__ == "__main__":
    if sys.argv[1:2] == ["read"]:
        read(sys.argv[2])
    else:
        gadget()
        swift()
        absurd()
