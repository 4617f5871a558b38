"""What is made of the peers' times and pictures."""
import statistics

import numpy

BLOCK = 8


def read_values(file, width, height):
    """A picture as the peers leave it: 32-bit floats, rows from top to bottom."""
    return numpy.fromfile(file, numpy.float32).reshape(height, width)


def block_errors(picture, truth):
    """RMS of the error of each block of 8x8 pixels, as mres has them; at the right and the bottom, of what is left."""
    squares = (picture.astype(float) - truth) ** 2
    rows, columns = (numpy.arange(0, length, BLOCK) for length in squares.shape)

    def sums(values):
        return numpy.add.reduceat(numpy.add.reduceat(values, rows, axis=0), columns, axis=1)

    return numpy.sqrt(sums(squares) / sums(numpy.ones_like(squares)))


def error(picture, truth):
    blocks = block_errors(picture, truth)
    return {
        "rms": float(numpy.sqrt(numpy.mean((picture.astype(float) - truth) ** 2))),
        "block_p99": float(numpy.quantile(blocks, 0.99)),
        "block_max": float(blocks.max()),
    }


def summary(values):
    return {"median": statistics.median(values), "min": min(values), "max": max(values), "runs": len(values)}


def times(frames):
    """Of frames with and without a pass, drawn in turn: of the pass, and of both frames."""
    differences = [with_pass - without for with_pass, without in zip(frames["with"], frames["without"])]
    return {
        "time_ms": summary(differences),
        "frame_ms": {way: summary(values) for way, values in frames.items()},
    }
