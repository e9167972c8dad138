#!/usr/bin/python3
"""inv3_to_nifti.py PROJECT.inv3 OUT.nii: the grey volume of an InVesalius project as an uncompressed NIfTI-1 file.

An .inv3 file is a gzipped tar of property lists and raw arrays. The matrix is stored slice by slice from the feet up, each slice
from the back to the front, each row from the patient's right to left as a DICOM row does; the project does not record the side.
"""

import plistlib
import struct
import sys
import tarfile

MILLIMETRES = 2
INT16 = 4
SCANNER_FRAME = 1


def read_project(path):
    with tarfile.open(path, "r:gz") as archive:
        members = {member.name.rsplit("/", 1)[-1]: member for member in archive.getmembers()}
        project = plistlib.loads(archive.extractfile(members["main.plist"]).read())
        voxels = archive.extractfile(members[project["matrix"]["filename"]]).read()
    return project, voxels


def nifti_header(dims, spacing):
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *dims, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, INT16, 16)
    struct.pack_into("<8f", header, 76, 1, *spacing, 0, 0, 0, 0)
    struct.pack_into("<f", header, 108, len(header))
    header[123] = MILLIMETRES
    struct.pack_into("<2h", header, 252, 0, SCANNER_FRAME)
    centre = [0.5 * step * (count - 1) for step, count in zip(spacing, dims)]
    # To right, anterior, superior: the file's first axis runs to the left.
    struct.pack_into("<4f", header, 280, -spacing[0], 0, 0, centre[0])
    struct.pack_into("<4f", header, 296, 0, spacing[1], 0, -centre[1])
    struct.pack_into("<4f", header, 312, 0, 0, spacing[2], -centre[2])
    header[344:348] = b"n+1\0"
    return bytes(header)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    project, voxels = read_project(sys.argv[1])
    matrix = project["matrix"]
    dims = [int(count) for count in reversed(matrix["shape"])]
    expected = 2 * dims[0] * dims[1] * dims[2]
    if matrix["dtype"] != "int16" or len(voxels) != expected:
        sys.exit(f"{sys.argv[1]}: {matrix['dtype']}, {len(voxels)} bytes; allowed: int16, {expected} bytes for {dims}")
    with open(sys.argv[2], "wb") as out:
        out.write(nifti_header(dims, [float(step) for step in project["spacing"]]))
        out.write(voxels)


if __name__ == "__main__":
    main()
