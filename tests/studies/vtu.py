"""Arrays of a VTU file as the program writes it: binary, compressed with zlib (VTK file formats, "XML")."""
import base64
import re
import struct
import zlib

CODES = {"Float32": "f", "Float64": "d", "Int32": "i", "UInt32": "I", "UInt8": "B"}


def read(path):
    """By name, a list of numbers or of tuples of components; the positions are called `points`."""
    arrays = {}
    for entries, body in re.findall(r"<DataArray ([^>]*)>\s*([^<]*?)\s*</DataArray>", path.read_text()):
        entries = dict(re.findall(r'(\w+)="([^"]*)"', entries))
        if entries.get("format") == "binary":
            code, raw = CODES[entries["type"]], decompress(body)
            values = struct.unpack(f"<{len(raw) // struct.calcsize(code)}{code}", raw)
            n = int(entries.get("NumberOfComponents", 1))
            arrays[entries.get("Name", "points")] = [values[i:i + n] for i in range(0, len(values), n)] if n > 1 else values
    return arrays


def decompress(body):
    """Blocks behind a header of its own in base64: their number, two sizes, their compressed lengths."""
    n_blocks, = struct.unpack("<I", base64.b64decode(body[:8])[:4])
    header = 4 * (3 + n_blocks)
    end = 4 * ((header + 2) // 3)
    lengths = struct.unpack(f"<{3 + n_blocks}I", base64.b64decode(body[:end])[:header])[3:]
    data, raw, begin = base64.b64decode(body[end:]), b"", 0
    for length in lengths:
        raw += zlib.decompress(data[begin:begin + length])
        begin += length
    return raw
