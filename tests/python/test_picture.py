"""Pictures without a display."""

import numpy as np
import pytest

import aomd

BALL = aomd.sample("sphere")


def test_a_picture_is_an_array():
    picture = aomd.render(BALL, size=(120, 90))
    assert picture.shape == (90, 120, 4) and picture.dtype == np.uint8
    assert (picture[..., 3] == 255).all()
    assert not (picture[45, 60] == picture[2, 2]).all()


def test_a_picture_without_a_background():
    picture = aomd.render(BALL, size=(120, 90), transparent=True)
    assert picture[0, 0, 3] == 0 and picture[45, 60, 3] == 255


def test_the_same_picture_each_time():
    first, second = (aomd.render(BALL, size=(120, 90)) for _ in range(2))
    assert aomd.image_difference(first, second) == {
        "same_size": True, "ssim": 1.0, "differing_pixels": 0, "largest_channel_difference": 0}


def test_colour_and_camera():
    pictures = [aomd.render(aomd.sample("bracket"), size=(120, 90), **options)
                for options in ({}, {"color": "quality"}, {"camera": "top"},
                                {"commands": ["theme dark"]})]
    for first in range(4):
        for second in range(first):
            found = aomd.image_difference(pictures[first], pictures[second])
            assert found["differing_pixels"] > 100


def test_a_volume():
    picture = aomd.render(aomd.sample("layered-beam"), size=(120, 90), transparent=True)
    assert (picture[..., 3] > 0).sum() > 500


def test_what_is_no_command_is_refused():
    with pytest.raises(aomd.UsageError, match="rainbow"):
        aomd.render(BALL, size=(80, 60), color="rainbow")
    with pytest.raises(aomd.LimitError, match="a picture is 1 to 16384 pixels wide and high"):
        aomd.render(BALL, size=(0, 60))


def test_notebooks_show_it():
    assert BALL._repr_png_().startswith(b"\x89PNG\r\n")
    assert aomd.to_png(np.zeros((2, 3, 4), np.uint8)) == aomd.to_png(np.zeros((2, 3, 4), np.uint8))
    with pytest.raises(ValueError, match="has the shape"):
        aomd.to_png(np.zeros((2, 3)))
