// SPDX-License-Identifier: MIT
// Nothing: a program that is built for its precompiled headers, which the tests share.
int main() {}
