// What all tests include is compiled ahead, with this file as its owner.
